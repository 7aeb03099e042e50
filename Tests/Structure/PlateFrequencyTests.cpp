#include "PlateExamples.h"

using namespace antinode;
using namespace antinode::examples;

namespace
{
Eigen::VectorXd hertz (const ModalModel& model)
{
    return model.angularFrequencies / (2 * std::numbers::pi);
}
} // namespace

TEST_CASE ("All 21 combinations of edges, two aspect ratios, first nine frequencies to 1e-5", "[structure][plate]")
{
    for (const auto& [edges, ratios] : plateReferences()["edge_combinations_computed"].items())
        for (const auto& [ratio, expected] : ratios.items())
        {
            CAPTURE (edges, ratio);
            const auto plate = barePlate (edges, 1, ratio == "1" ? 1 : 1.5);
            const auto model = solved (plate, 9);
            CHECK (largestDeviation (lambdas (plate, model), expected) < 1e-5);
            CHECK (model.frequencyErrors.maxCoeff() < 1e-5);
        }
}

TEST_CASE ("Levy's six cases to 1e-6", "[structure][plate]")
{
    for (const auto& [edges, expected] : plateReferences()["levy_computed"].items())
    {
        CAPTURE (edges);
        const auto plate = barePlate (edges, 1, 1);
        CHECK (largestDeviation (lambdas (plate, solved (plate, 6)), expected) < 1e-6);
    }
}

TEST_CASE ("Leissa's printed values are upper bounds within one per cent", "[structure][plate]")
{
    for (const auto& [edges, expected] : plateReferences()["leissa_1973_printed"].items())
    {
        CAPTURE (edges);
        const auto plate = barePlate (edges, 1, 1);
        const auto values = lambdas (plate, solved (plate, 6));

        for (std::size_t k = 0; k < expected.size(); ++k)
        {
            const auto printed = expected[k].get<double>();
            CHECK (values[static_cast<Eigen::Index> (k)] < printed * (1 + 3e-5)); // printed with five digits
            CHECK (values[static_cast<Eigen::Index> (k)] > printed * 0.99);
        }
    }
}

TEST_CASE ("NAFEMS FV12, FV13 and FV16 to 1e-5 of the exact thin-plate values", "[structure][plate]")
{
    for (const auto& [edges, expected] : plateReferences()["nafems"].items())
    {
        if (edges == "plate")
            continue;

        CAPTURE (edges);
        auto plate = barePlate (edges, 10, 10);
        plate.common.thickness = 0.05;
        CHECK (largestDeviation (hertz (solved (plate, 8)), expected) < 1e-5);
    }
}

TEST_CASE ("A simply supported orthotropic plate to 1e-7 of the closed form", "[structure][plate]")
{
    // D11 = 12, D12 = 2, D22 = 3, D66 = 1.5 N m, m = 7 kg/m^2, 0.3 m x 0.2 m.
    const auto& reference = plateReferences()["orthotropic_SSSS"];
    auto plate = barePlate ("SSSS", 0.3, 0.2);
    const auto perStiffness = 12 / std::pow (plate.common.thickness, 3);
    const auto ratio12 = 2.0 / 3, ratio21 = 2.0 / 12;
    plate.common.material = { perStiffness * 12 * (1 - ratio12 * ratio21), perStiffness * 3 * (1 - ratio12 * ratio21),
                              perStiffness * 1.5, ratio12, 7 / plate.common.thickness };
    CHECK (largestDeviation (hertz (solved (plate, 12)), reference["f_Hz"]) < 1e-7);
}

TEST_CASE ("Rigid motions are counted, not listed", "[structure][plate]")
{
    CHECK (solved (barePlate ("FFFF", 1, 1), 3).rigidBodyModes == 3);
    CHECK (solved (barePlate ("SFFF", 1, 1), 3).rigidBodyModes == 1);
    CHECK (solved (barePlate ("SSFF", 1, 1), 3).rigidBodyModes == 0);
    CHECK (solved (barePlate ("CFFF", 1, 1), 3).rigidBodyModes == 0);
}

TEST_CASE ("All modes up to a frequency, as many as inertia counts", "[structure][plate]")
{
    auto plate = barePlate ("SSSS", 0.3, 0.2);
    const auto model = solved (plate, 40);
    plate.common.maximumFrequency = (model.frequencyHz (24) + model.frequencyHz (25)) / 2;
    const auto limited = solved (plate);
    CHECK (limited.modes() == 25);
    CHECK ((limited.angularFrequencies - model.angularFrequencies.head (25)).norm()
           < 1e-5 * limited.angularFrequencies.norm());

    plate.common.maximumFrequency = model.frequencyHz (0) / 2;
    CHECK_THROWS_WITH (solved (plate), Catch::Contains ("no mode up to its maximum frequency"));
    plate.common.maximumFrequency = 1e7;
    CHECK_THROWS_WITH (solved (plate), Catch::Contains ("up to 500 modes below it"));
}

TEST_CASE ("A narrow plate is a beam where Poisson's ratio is zero", "[structure][plate]")
{
    // Clamped and free: (beta L)^2 = 3.5160153, 22.034492, 61.697214; twisting modes lie between.
    const auto plate = barePlate ("CFFF", 1, 0.002, 0);
    const auto values = lambdas (plate, solved (plate, 4));
    CHECK (values[0] == Approx (3.516015269).epsilon (1e-6));
    CHECK (values[1] == Approx (22.03449156).epsilon (1e-6));
    CHECK (values[2] == Approx (61.69721441).epsilon (1e-6));
}

TEST_CASE ("The user is told where waves come near the thickness", "[structure][plate]")
{
    CHECK (solved (barePlate ("FFFF", 1, 1), 10).warnings.empty());
    auto thick = barePlate ("FFFF", 1, 1);
    thick.common.thickness = 0.1;
    const auto warnings = solved (thick, 10).warnings;
    REQUIRE (warnings.size() == 1);
    CHECK_THAT (warnings[0], Catch::Contains ("thin-plate theory overestimates frequencies by more than 2 %"));
}

TEST_CASE ("One to five hundred modes", "[structure][plate]")
{
    CHECK (solved (barePlate ("CFFF", 0.2, 0.12), 1).modes() == 1);
    const auto many = solved (barePlate ("CFFF", 0.2, 0.12), 500);
    CHECK (many.modes() == 500);
    CHECK (many.frequencyErrors.maxCoeff() < 1e-3);
    CHECK_THROWS_WITH (solved (barePlate ("CFFF", 0.2, 0.12), 501), Catch::Contains ("allowed: 1 to 500"));
}
