#include <antinode_documents/DesignFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

#include <numbers>
#include <random>

using namespace antinode;

namespace
{
ModalModel smallModel()
{
    ModalModel model;
    model.name = "small";
    model.angularFrequencies = Eigen::Vector2d (2 * std::numbers::pi * 420, 6000);
    model.dampingRatios = Eigen::Vector2d (0.003, 0.01);
    model.surface.points = Eigen::MatrixX2d::Zero (3, 2);
    model.surface.points.col (0) << -0.05, 0, 0.04;
    model.shapes = Eigen::MatrixXd::Ones (3, 2);
    model.ceramics = { { "C1", 0, 0, 0, 0, 150 }, { "C2", 0, 0, 0, 0, 100 } };
    return model;
}

/** A design whose numbers use all bits of a double. */
FocusDesign irregularDesign()
{
    std::mt19937 random (3);
    std::uniform_real_distribution<double> number (-1, 1);
    const auto next = [&] { return number (random); };

    FocusDesign design;
    design.description.name = "irregular";
    design.description.targets = { { TargetShape::sinc, 0.024, 0, 0.025, 0.04, 1 } };
    design.description.focusTime = 0.025;
    design.target.field = Eigen::Vector3d (0, 0.04, 0.01);
    design.target.modalVelocities = Eigen::Vector2d (0.002, -0.001);
    design.truncatedField = Eigen::Vector3d (0.001, 0.039, 0.011);
    design.controlledModes = { 1 };
    design.growth = { 10 };
    design.cycles = { 4 };
    design.captured = 0.96;
    design.certificate.status = AllocationStatus::optimal;
    design.certificate.gap = 1e-9;
    design.choices = { "growth 10: all modes rise together" };
    design.warnings = { "a \"warning\"" };

    auto& program = design.program;
    program.focusTime = 0.025 + 1e-3 * next();
    program.voltageLimits = Eigen::Vector2d (50, 100.0 / 3);

    for (int c = 0; c < 40; ++c)
        program.oscillations.push_back (
            { c % 2, 0.01 + 0.005 * next(), 0.025, 1e3 * next(), 1e5 + 9e4 * next(), next(), next() });

    program.oscillations.push_back ({ 1, 0, 0.025, 0, 0, 0, -2.5 });                                // A constant.
    program.oscillations.push_back ({ 1, 0.026, 0.1, -2000.0 / 3, 1e5 / 7, 0.1, -2.5, 100.0 / 3 }); // A brake.
    program.oscillations.back().counterShare = { 0.1 / 3, -0.2 / 7 };
    program.allocation = Eigen::MatrixXd::NullaryExpr (2, 42, next);
    return design;
}

double counterShare (const nlohmann::json& oscillation, std::size_t part)
{
    return oscillation.contains ("counter_share") ? oscillation["counter_share"][part].get<double>() : 0;
}
} // namespace

TEST_CASE ("Other programs read what is played from a design to the bit", "[files]")
{
    const auto program = irregularDesign().program;
    const auto read = nlohmann::json::parse (designToJson (irregularDesign(), smallModel()).dump (1));
    CHECK (read["schema"] == "antinode.design/1");
    CHECK (read["focus_time_s"] == program.focusTime);
    CHECK (read["voltage_limits_V"] == std::vector (program.voltageLimits.begin(), program.voltageLimits.end()));
    REQUIRE (read["allocation"].size() == 2);

    for (Eigen::Index i = 0; i < 2; ++i)
        CHECK (read["allocation"][static_cast<std::size_t> (i)]
               == std::vector (program.allocation.row (i).begin(), program.allocation.row (i).end()));

    REQUIRE (read["oscillations"].size() == program.oscillations.size());

    for (std::size_t c = 0; c < program.oscillations.size(); ++c)
    {
        const auto& a = read["oscillations"][c];
        const auto& b = program.oscillations[c];
        CHECK (a["mode"] == b.mode + 1);
        CHECK (a["start_s"] == b.start);
        CHECK (a["end_s"] == b.end);
        CHECK (a["growth_per_s"] == b.growth);
        CHECK (a.value ("angular_frequency_rad_s", 0.0) == b.angularFrequency);
        CHECK (a["in_phase"] == b.inPhase);
        CHECK (a["quadrature"] == b.quadrature);
        CHECK (a.value ("free_decay_per_s", 0.0) == b.freeDecay);
        CHECK (std::complex<double> (counterShare (a, 0), counterShare (a, 1)) == b.counterShare);
    }
}

TEST_CASE ("A design says what is played, in the units of its keys", "[files]")
{
    auto design = irregularDesign();
    design.program.oscillations = { { 0, 0.01, 0.025, 80, 2 * std::numbers::pi * 420, 3, -4 } };
    design.program.allocation = Eigen::Vector2d (0.5, -0.25);
    const auto json = designToJson (design, smallModel());
    CHECK (json["schema"] == "antinode.design/1");
    CHECK (json["device"] == "small");
    CHECK (json["oscillations"].dump()
           == "[{\"mode\":1,\"start_s\":0.01,\"end_s\":0.025,\"growth_per_s\":80.0,\"frequency_Hz\":420.0,"
              "\"angular_frequency_rad_s\":2638.9378290154264,\"in_phase\":3.0,\"quadrature\":-4.0}]");
    CHECK (json["allocation"].dump() == "[[0.5],[-0.25]]");
    CHECK (json["ceramics"].dump() == "[\"C1\",\"C2\"]");
    CHECK (json["certificate"]["status"] == "optimal");
    CHECK (json["controlled_modes"][0]["mode"] == 2);
    CHECK (json["controlled_modes"][0]["cycles"] == 4);
    CHECK (json["choices"] == design.choices);
    CHECK (json["warnings"] == design.warnings);
    CHECK (json["field"]["x_mm"].size() == 3);
    CHECK (json["conventions"]["mode"].get<std::string>().find ("lowest is 1") != std::string::npos);
}

TEST_CASE ("The focus inside a design is a focus file of its own", "[files]")
{
    const auto json = parseJson (designToJson (irregularDesign(), smallModel()).dump(), "design.json");
    const auto focus = readFocus (json["focus"], "design.json");
    CHECK (focus.targets[0].x == 0.024);
    CHECK (focus.focusTime == 0.025);
}
