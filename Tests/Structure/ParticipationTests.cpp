#include "StructureExamples.h"

#include <antinode_structure/ElementChain.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** Two pairs of ceramics so thin that the beam stays uniform; the moment per volt does not depend on their thickness
    then. */
std::vector<CeramicDescription> thinCeramics()
{
    auto first = ceramicPair (-0.067, 0.021, 0.006, 1e-12);
    auto second = ceramicPair (0.013, 0.037, 0.01, 1e-12);
    second.polarity = -1;
    return { first, second };
}

/** kappa of such a pair, N m / V: 2 e31 (h/2) B_p. */
double thinMoment (const CeramicDescription& ceramic, double thickness)
{
    return ceramic.polarity * ceramic.material.d31 * ceramic.material.youngsModulus * thickness * ceramic.sizeY;
}

/** d phi_k / dx of a clamped-free beam at a distance from the clamp, phi = (cosh - cos - s (sinh - sin)) / sqrt (mass),
    written so that the growing exponential keeps its small factor 1 - s to full precision. */
double cantileverSlope (double root, double length, double mass, double distance)
{
    const auto denominator = std::cosh (root) + std::cos (root);
    const auto oneMinusS = (std::exp (-root) + std::cos (root) + std::sin (root)) / denominator;
    const auto s = 1 - oneMinusS;
    const auto z = root / length * distance;
    const auto value = oneMinusS / 2 * std::exp (z) - (1 + s) / 2 * std::exp (-z) + std::sin (z) + s * std::cos (z);
    return root / length * value / std::sqrt (mass);
}

/** d phi_k / dx of a pinned beam, phi = sqrt (2 / mass) sin (beta x). */
double pinnedSlope (double root, double length, double mass, double distance)
{
    return root / length * std::sqrt (2 / mass) * std::cos (root / length * distance);
}

using SlopeFunction = double (*) (double root, double length, double mass, double distance);

void checkParticipation (const BeamDescription& beam, const std::vector<double>& roots, SlopeFunction slope)
{
    const auto model = solved (beam, static_cast<int> (roots.size()));
    const auto mass = beam.common.material.density * beam.length * beam.width * beam.common.thickness;

    for (std::size_t k = 0; k < roots.size(); ++k)
    {
        for (std::size_t i = 0; i < beam.common.ceramics.size(); ++i)
        {
            const auto& ceramic = beam.common.ceramics[i];
            const auto left = ceramic.x + beam.length / 2;
            const auto turned =
                slope (roots[k], beam.length, mass, left + ceramic.sizeX) - slope (roots[k], beam.length, mass, left);
            const auto exact = thinMoment (ceramic, beam.common.thickness) * turned;
            const auto actual = model.participation (static_cast<Eigen::Index> (k), static_cast<Eigen::Index> (i));
            CAPTURE (k, i, exact, actual / exact - 1);
            CHECK (std::abs (actual - exact) < 1e-6 * std::abs (exact));
        }
    }
}
} // namespace

TEST_CASE ("a patch on a uniform cantilever takes part by the difference of the closed form's slopes", "[structure]")
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    beam.common.ceramics = thinCeramics();
    checkParticipation (beam,
                        { 1.8751040687119611, 4.694091132974175, 7.854757438237611, 10.995540734875467,
                          14.13716839104647, 17.27875953208824, 20.42035225104125, 23.561944901806445, 26.7035375555183,
                          29.845130209102823 },
                        cantileverSlope);
}

TEST_CASE ("a patch on a uniform pinned beam takes part by the difference of the closed form's slopes", "[structure]")
{
    auto beam = uniformBeam (EdgeCondition::simplySupported, EdgeCondition::simplySupported);
    beam.common.ceramics = thinCeramics();
    std::vector<double> roots;

    for (int k = 1; k <= 10; ++k)
        roots.push_back (k * std::numbers::pi);

    checkParticipation (beam, roots, pinnedSlope);
}

TEST_CASE ("polarity turns a ceramic's participation, series wiring halves it", "[structure]")
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    beam.common.ceramics = { ceramicPair (-0.05, 0.03, 0.008, 0.5e-3) };
    const Eigen::MatrixXd participation = solved (beam, 5).participation;

    beam.common.ceramics[0].polarity = -1;
    CHECK (solved (beam, 5).participation == -participation);

    beam.common.ceramics[0].wiring = CeramicWiring::series;
    CHECK ((solved (beam, 5).participation + participation / 2).norm() < 1e-12 * participation.norm());
}

TEST_CASE ("a positive voltage bulges a surface outward where d31 is negative", "[structure]")
{
    auto beam = uniformBeam (EdgeCondition::simplySupported, EdgeCondition::simplySupported);
    beam.common.ceramics = { ceramicPair (0, 0.1, 0.01, 0.5e-3) };
    const auto model = solved (beam, 1);

    // The first shape is positive, so a positive participation lifts the middle.
    CHECK (model.shapes.col (0).minCoeff() > -1e-9);
    CHECK (model.participation (0, 0) > 0);
}

TEST_CASE ("a pair of ceramics stiffens a section after Steiner", "[structure]")
{
    // 20 x 1 mm of aluminium with 20 x 0.5 mm of 62.5 GPa on both sides: EI = .1166667 + .7291667 N m^2.
    const auto common = plainCommon (1e-3);
    const auto section = ceramicSection (common, 0.02, ceramicPair (0, 0.05, 0.02, 0.5e-3));
    CHECK (bareSection (common, 0.02).bendingStiffness == Approx (0.11666666666666668).epsilon (1e-12));
    CHECK (section.bendingStiffness == Approx (0.8458333333333334).epsilon (1e-12));
    CHECK (section.massPerLength == Approx (0.21).epsilon (1e-12));
    CHECK (section.axialStiffness == Approx (70e9 * 2e-5 + 62.5e9 * 2e-5).epsilon (1e-12));
}

TEST_CASE ("a section shears as the stress that balances its moment", "[structure]")
{
    // 10 x 2 mm of aluminium; with 5 x 0.5 mm of NCE51 on 0.05 mm of epoxy on one side, integrated with 40 digits.
    auto common = plainCommon (2e-3);
    common.theory = BendingTheory::thick;
    auto ceramic = ceramicPair (0, 0.009, 0.005, 0.5e-3);
    ceramic.mounting = CeramicMounting::oneSide;
    ceramic.glue = GlueLayer { 50e-6, { 2.5e9, 2.5e9, 2.5e9 / 2.72, 0.36, 1150 } };
    const auto bare = bareSection (common, 0.01), section = ceramicSection (common, 0.01, ceramic);
    CHECK (bare.shearStiffness == Approx (5.0 / 6 * 70e9 / 2.66 * 2e-5).epsilon (1e-12));
    CHECK (bare.rotaryInertia == Approx (2700 * 2e-5 * 4e-6 / 12).epsilon (1e-12));
    CHECK (section.bendingStiffness == Approx (0.70797206197519).epsilon (1e-12));
    CHECK (section.shearStiffness == Approx (378986.27821509).epsilon (1e-12));
    CHECK (section.rotaryInertia == Approx (4.6214522173023e-8).epsilon (1e-12));
}

TEST_CASE ("a ceramic on one side bends a section about its shifted neutral axis", "[structure]")
{
    // Moments of E dA about the substrate's mid-plane: EI = S2 - S1^2 / S0, arm = d - S1 / S0.
    const auto common = plainCommon (1e-3);
    auto ceramic = ceramicPair (0, 0.05, 0.01, 0.5e-3);
    ceramic.mounting = CeramicMounting::oneSide;
    const auto substrate = 70e9 * 0.02 * 1e-3;
    const auto added = 62.5e9 * 0.01 * 0.5e-3;
    const auto s0 = substrate + added;
    const auto s1 = added * 0.75e-3;
    const auto s2 = substrate * 1e-6 / 12 + added * (0.25e-6 / 12 + 0.75e-3 * 0.75e-3);

    const auto section = ceramicSection (common, 0.02, ceramic);
    CHECK (section.bendingStiffness == Approx (s2 - s1 * s1 / s0).epsilon (1e-12));
    CHECK (section.massPerLength == Approx (2700 * 2e-5 + 7800 * 0.5e-5).epsilon (1e-12));
    CHECK (section.axialStiffness == Approx (s0).epsilon (1e-12));
    CHECK (momentPerVolt (common, 0.02, ceramic)
           == Approx (-195e-12 * 62.5e9 * 0.01 * (0.75e-3 - s1 / s0)).epsilon (1e-12));
}
