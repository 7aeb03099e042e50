#include "StructureExamples.h"

#include <antinode_model/ModalModel.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** A cantilever of 300 x 20 x 1 mm with a pair of ceramics from 40 to 90 mm, as wide as the beam. */
BeamDescription patchedCantilever()
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    beam.length = 0.3;
    beam.width = 0.02;
    beam.common.ceramics = { ceramicPair (-0.085, 0.05, 0.02, 0.5e-3) };
    return beam;
}
} // namespace

TEST_CASE ("a cantilever with a pair of ceramics has the frequencies of its exact dynamic stiffness", "[structure]")
{
    // Exact dynamic stiffness matrix of three uniform parts, roots counted after Wittrick and Williams (1971).
    constexpr std::array exact { 10.718457355108656, 51.802183516216715, 145.424490565443,   315.312240107388,
                                 513.8522001440891,  741.4848099159134,  1095.8502415482449, 1547.1430432057234 };
    const auto model = solved (patchedCantilever(), 8);

    for (Eigen::Index k = 0; k < 8; ++k)
    {
        const auto error = std::abs (model.frequencyHz (k) / exact[static_cast<std::size_t> (k)] - 1);
        CAPTURE (k, error);
        CHECK (error < 1e-8);
        CHECK (error <= model.frequencyErrors[k]);
    }
}

TEST_CASE ("a ceramic along the whole beam makes it uniform again", "[structure]")
{
    auto beam = patchedCantilever();
    beam.common.ceramics = { ceramicPair (0, 0.3, 0.02, 0.5e-3) };
    const auto model = solved (beam, 3);

    // EI = 0.8458333 N m^2 and mu = 0.21 kg/m, worked out by hand; first roots of the clamped-free beam.
    const auto scale = std::sqrt (0.84583333333333333 / 0.21) / (0.3 * 0.3);
    CHECK (model.angularFrequencies[0] == Approx (1.8751040687119611 * 1.8751040687119611 * scale).epsilon (1e-9));
    CHECK (model.angularFrequencies[2] == Approx (7.854757438237611 * 7.854757438237611 * scale).epsilon (1e-9));
}

TEST_CASE ("two ceramics that touch stiffen a beam like one", "[structure]")
{
    auto beam = patchedCantilever();
    const auto whole = solved (beam, 6);
    beam.common.ceramics = { ceramicPair (-0.0725, 0.025, 0.02, 0.5e-3), ceramicPair (-0.0975, 0.025, 0.02, 0.5e-3) };
    const auto halves = solved (beam, 6);

    CHECK ((halves.angularFrequencies - whole.angularFrequencies).norm() < 1e-9 * whole.angularFrequencies.norm());
    const Eigen::VectorXd sum = halves.participation.rowwise().sum();
    CHECK ((sum - whole.participation.col (0)).norm() < 1e-8 * whole.participation.norm());
}

TEST_CASE ("a gap between ceramics softens a beam in proportion to its width, however narrow", "[structure]")
{
    const auto gapped = [] (double gap)
    {
        auto beam = patchedCantilever();
        const auto length = 0.025 - gap / 2;
        beam.common.ceramics = { ceramicPair (-0.06 - length / 2, length, 0.02, 0.5e-3),
                                 ceramicPair (-0.11 + length / 2, length, 0.02, 0.5e-3) };
        return solved (beam, 1).angularFrequencies[0];
    };
    const auto closed = gapped (0);
    const auto narrow = closed - gapped (1e-7);
    const auto wide = closed - gapped (1e-6);

    CHECK (narrow > 0);
    CHECK (wide / narrow == Approx (10).epsilon (1e-3));
}

TEST_CASE ("the deflection of a bimorph cantilever at rest is the sum of its modes", "[structure]")
{
    // Two layers of PVDF of 0.5 mm, 100 mm long, 5 mm wide, 1 V across both: 3 e31 U L^2 / (2 E h^2) = 3.45e-7 m with
    // e31 = 0.046 C/m^2, E = 2 GPa, h = 1 mm (Tzou 1989; Hwang and Park 1993). The substrate between them is next to
    // nothing.
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    beam.length = 0.1;
    beam.width = 0.005;
    beam.common.thickness = 1e-9;
    auto ceramic = ceramicPair (0, 0.1, 0.005, 0.5e-3);
    ceramic.material = { 2e9, 0.29, 1800, 0.046 / 2e9, 0 };
    ceramic.wiring = CeramicWiring::series;
    beam.common.ceramics = { ceramic };
    const auto model = solved (beam, 20);

    const auto deflection = [&] (double x)
    {
        const auto shapes = shapesAt (model, x, 0);
        return (shapes.transpose().array() * model.participation.col (0).array()
                / model.angularFrequencies.array().square())
            .sum();
    };
    CHECK (deflection (0.05) == Approx (3.45e-7).epsilon (1e-3));
    CHECK (deflection (0.01) == Approx (3.45e-7 * 0.36).epsilon (1e-3));
}
