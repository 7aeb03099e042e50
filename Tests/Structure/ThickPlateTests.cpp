#include "PlateExamples.h"

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** omega a^2 / pi^2 sqrt (rho h / D) of the lowest modes of a square plate of side 1 m. */
Eigen::VectorXd parameters (const std::string& edges, double thickness, BendingTheory theory)
{
    auto plate = barePlate (edges, 1, 1);
    plate.common.thickness = thickness;
    plate.common.theory = theory;
    return lambdas (plate, solveStructure ({ "square", "", plate }, 6)) / (std::numbers::pi * std::numbers::pi);
}
} // namespace

TEST_CASE ("A thick simply supported plate has Mindlin's frequencies", "[structure][plate][thick]")
{
    // Liew, Xiang, Kitipornchai, Comput. Struct. 49 (1993) 1-29, Poisson's ratio 0.3, shear factor 5/6; five digits.
    const auto tenth = parameters ("SSSS", 0.1, BendingTheory::thick);
    CHECK (tenth[0] == Approx (1.9317).epsilon (3e-5));
    CHECK (tenth[1] == Approx (4.6084).epsilon (3e-5));
    CHECK (tenth[2] == Approx (4.6084).epsilon (3e-5));
    CHECK (tenth[3] == Approx (7.0716).epsilon (3e-5));
    const auto fifth = parameters ("SSSS", 0.2, BendingTheory::thick);
    CHECK (fifth[0] == Approx (1.7679).epsilon (3e-5));
    CHECK (fifth[1] == Approx (3.8656).epsilon (3e-5));
    CHECK (fifth[3] == Approx (5.5879).epsilon (3e-5));
}

TEST_CASE ("Of a clamped thick plate the correction leaves less than half of the error", "[structure][plate][thick]")
{
    // The same source. Shear softens the clamping, too, which no wave number knows.
    const auto thin = parameters ("CCCC", 0.1, BendingTheory::thin);
    const auto corrected = parameters ("CCCC", 0.1, BendingTheory::thick);

    for (const auto& [mode, exact] : { std::pair { 0, 3.2954 }, { 1, 6.2858 }, { 3, 8.8098 } })
    {
        CHECK (corrected[mode] > exact);
        CHECK (corrected[mode] - exact < 0.45 * (thin[mode] - exact));
        CHECK (corrected[mode] / exact < 1.065);
    }
}

TEST_CASE ("The correction vanishes on thin plates, and the warning states it on thick ones",
           "[structure][plate][thick]")
{
    const auto thin = parameters ("SSSS", 1e-3, BendingTheory::thin);
    const auto corrected = parameters ("SSSS", 1e-3, BendingTheory::thick);
    CHECK ((thin.cwiseQuotient (corrected).array() - 1).maxCoeff() < 2.5e-5); // (k h)^2 / 24 times 4.4

    auto plate = barePlate ("SSSS", 1, 1);
    plate.common.thickness = 0.1;
    const auto warned = solveStructure ({ "thick", "", plate }, 6).warnings;
    REQUIRE (warned.size() == 1);
    CHECK_THAT (warned[0], Catch::Contains ("overestimates") && Catch::Contains ("\"theory\": \"mindlin\""));
    plate.common.theory = BendingTheory::thick;
    const auto told = solveStructure ({ "thick", "", plate }, 6).warnings;
    REQUIRE (told.size() == 1);
    CHECK_THAT (told[0], Catch::Contains ("corrected"));
}
