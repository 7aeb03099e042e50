#include "SectionReferences.h"

#include "Support/CircularPlates.h"

#include <antinode_outline/PathBuilder.h>

#include <numbers>

using namespace antinode;
using namespace antinode::examples;

namespace
{
constexpr double plateRadius = 0.06, ceramicRadius = 0.00985;

/** A round plate of glass, 120 mm x 0.7 mm, with a bender in its middle. */
OutlinedPlate plateWithBender()
{
    OutlinedPlate plate;
    plate.common = plainCommon (0.7e-3);
    plate.common.material = findElasticMaterial ("glass").value();
    plate.outline.paths = { circlePath ({ 0, 0 }, plateRadius, 0) };
    plate.edges = { {} };
    auto bender = benderExample();
    bender.shape = CeramicShape::disc;
    bender.carrier->electrodeDiameter = bender.carrier->ceramicDiameter;
    bender.x = bender.y = -bender.sizeX / 2;
    plate.common.ceramics = { bender };
    return plate;
}

/** The same as three concentric parts. */
tests::CircularPlate exactPlate()
{
    const auto& sections = sectionReferences()["buzzer"]["on_glass"];
    const auto ring = [&] (double radius, const char* name)
    {
        const auto& section = sections[name];
        return tests::PlateRing { radius, section["D11"].get<double>(), section["nu_eff"].get<double>(),
                                  section["m"].get<double>() };
    };
    return { 0, { ring (ceramicRadius, "inner"), ring (0.0135, "outer"), ring (plateRadius, "plate") }, {}, {} };
}
} // namespace

TEST_CASE ("A plate with a disc bender: thirty frequencies to 1e-4, participation to 1e-3",
           "[structure][section][immersed]")
{
    constexpr int count = 30;
    const auto model = solveStructure ({ "bender", "", plateWithBender() }, count);
    const auto exact = tests::circularModes (exactPlate(), count);
    const auto moment = std::abs (sectionReferences()["buzzer"]["on_glass"]["kappa"].get<double>());
    const auto largest = model.participation.cwiseAbs().maxCoeff();
    CHECK (model.rigidBodyModes == 3);

    // Over a disc the Laplacian is the flux of the slope through its edge; with nodal diameters it vanishes.
    for (Eigen::Index k = 0; k < count; ++k)
    {
        const auto& mode = exact[static_cast<std::size_t> (k)];
        CHECK (model.angularFrequencies[k] == Approx (mode.angularFrequency).epsilon (1e-4));
        const auto flux = 2 * std::numbers::pi * ceramicRadius * slopeAtFirstRing (exactPlate(), mode.angularFrequency);
        const auto expected = mode.diameters > 0 ? 0 : moment * std::abs (flux);
        CHECK (std::abs (model.participation (k, 0)) == Approx (expected).epsilon (1e-3).margin (2e-3 * largest));
    }
}
