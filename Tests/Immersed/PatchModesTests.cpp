#include "BendingExamples.h"

#include <antinode_structure/BendingProblem.h>

#include <numbers>

using namespace antinode;
using namespace antinode::examples;

namespace
{
BendingSection difference (const BendingSection& a, const BendingSection& b)
{
    return { a.stiffness - b.stiffness, a.massPerArea - b.massPerArea };
}

/** A round plate of glass, 120 mm x 0.7 mm, with a disc of a ceramic pair about its middle. */
struct PlateWithDisc
{
    double radius = 0.01; ///< Of the disc, m.
    double stiffness = 12.785473343036744, poissonRatio = 0.2951993026195663, massPerArea = 6.43;
    tests::CircularEdge outer;
};

constexpr double glassRadius = 0.06, glassStiffness = 2.102599131287656, glassRatio = 0.22, glassMass = 1.75;

tests::CircularPlate circleWithDisc (const PlateWithDisc& plate)
{
    return { 0,
             { { plate.radius, plate.stiffness, plate.poissonRatio, plate.massPerArea },
               { glassRadius, glassStiffness, glassRatio, glassMass } },
             {},
             plate.outer };
}

BendingProblem problemWithDisc (const PlateWithDisc& plate, const Eigen::Vector2d& centre)
{
    BendingProblem problem;
    problem.section = isotropicSection (glassStiffness, glassRatio, glassMass);
    problem.outline.paths = { circlePath (centre, glassRadius, 0) };
    problem.edges = { plate.outer.translation >= tests::rigid ? clampedEdge : freeEdge };
    auto disc = discPatch (centre, plate.radius);
    disc.added =
        difference (isotropicSection (plate.stiffness, plate.poissonRatio, plate.massPerArea), problem.section);
    disc.moment << 1, 1, 0;
    problem.patches = { disc };
    return problem;
}

BendingProblem plateWithSquare (double angle)
{
    auto problem =
        unitPlate (0.22, { rectanglePath ({ 0.5, 0.35 }, { 1, 0.7 }, 0, { 0, 0, 0, 0 }, 0) }, { 4, supportedEdge });
    auto square = rectanglePatch ({ 0.42, 0.3 }, { 0.15, 0.15 }, angle);
    square.added = isotropicSection (5, 0.31, 2.6);
    square.moment << 1, 1, 0;
    problem.patches = { square };
    return problem;
}
} // namespace

TEST_CASE ("A disc: fifty frequencies to 1e-4, participation to 1e-3", "[immersed][plate]")
{
    const tests::CircularEdge clamped { tests::rigid, tests::rigid };
    const auto plate = GENERATE_COPY (values<PlateWithDisc> (
        { {}, { 0.005, 12.8, 0.1, 6.4, {} }, { 0.015, 5.9, 0.26, 4.1, {} }, { 0.01, 12.8, 0.3, 6.4, clamped } }));
    CAPTURE (plate.radius, plate.outer.translation);
    const auto problem = problemWithDisc (plate, { 0.01, -0.02 });
    const auto modes = bendingModes (problem, 50, resolutionFor (problem, 50, ModeAccuracy::usual));
    const auto exact = tests::circularModes (circleWithDisc (plate), 50);

    // Over the disc the Laplacian is the flux of the slope through its edge; with nodal diameters it vanishes. Modes
    // with frequencies closer than the tolerance may be mixed.
    for (std::size_t k = 0; k < exact.size(); ++k)
    {
        double found = 0, expected = 0;

        for (std::size_t l = 0; l < exact.size(); ++l)
            if (std::abs (exact[l].angularFrequency / exact[k].angularFrequency - 1) < 1e-3)
            {
                const auto flux = 2 * std::numbers::pi * plate.radius
                                  * slopeAtFirstRing (circleWithDisc (plate), exact[l].angularFrequency);
                expected += exact[l].diameters > 0 ? 0 : flux * flux;
                found += std::pow (modes.participation (static_cast<Eigen::Index> (l), 0), 2);
            }

        CHECK (std::sqrt (modes.eigenvalues[static_cast<Eigen::Index> (k)])
               == Approx (exact[k].angularFrequency).epsilon (1e-4));
        CHECK (std::sqrt (found) == Approx (std::sqrt (expected)).epsilon (1e-3).margin (0.02)); // 1e-4 of the largest.
    }
}

TEST_CASE ("The reference values of a disc are those of the determinant", "[immersed][plate]")
{
    const auto& reference = outlineReferences()["disc_ceramic"]["disc_2side_free"]["n0"];
    const auto exact = tests::circularModes (circleWithDisc ({}), 30);
    std::size_t next = 0;

    for (const auto& mode : exact)
        if (mode.diameters == 0)
        {
            CHECK (mode.angularFrequency / (2 * std::numbers::pi)
                   == Approx (reference["f_Hz"][next].get<double>()).epsilon (1e-8));
            const auto participation =
                0.0177 * 2 * std::numbers::pi * 0.01 * slopeAtFirstRing (circleWithDisc ({}), mode.angularFrequency);
            CHECK (std::abs (participation)
                   == Approx (reference["alpha_N_per_sqrtkg_per_V"][next++].get<double>()).epsilon (1e-5));
        }

    CHECK (next >= 2);
}

TEST_CASE ("A square that is turned: frequencies to 2e-4, participation to 5e-3", "[immersed][plate]")
{
    const auto problem = plateWithSquare (std::numbers::pi / 6);
    const auto& reference = outlineReferences()["rotated_square"];
    const auto modes = bendingModes (problem, 20, resolutionFor (problem, 20, ModeAccuracy::usual));
    CHECK (deviationFrom (frequencies (modes), reference["values"]) < 2e-4);
    CHECK (deviationFrom (modes.participation.col (0).cwiseAbs(), reference["alpha_per_kappa"]) < 5e-3);
}

TEST_CASE ("Plate and square turned together keep their modes", "[immersed][plate]")
{
    const auto straight = plateWithSquare (0.4);
    auto turned = straight;
    const Eigen::Vector2d shift (0.3, 0.1);
    turned.outline = moved (straight.outline, -0.4, shift);
    const Eigen::Vector2d centre (std::cos (0.4) * 0.42 + std::sin (0.4) * 0.3,
                                  std::cos (0.4) * 0.3 - std::sin (0.4) * 0.42);
    auto square = rectanglePatch (centre + shift, { 0.15, 0.15 }, 0);
    square.added = straight.patches[0].added;
    square.moment = straight.patches[0].moment;
    turned.patches = { square };
    const auto a = bendingModes (straight, 20, resolutionFor (straight, 20, ModeAccuracy::usual));
    const auto b = bendingModes (turned, 20, resolutionFor (turned, 20, ModeAccuracy::usual));
    CHECK ((a.eigenvalues.array() / b.eigenvalues.array()).sqrt().maxCoeff() == Approx (1).epsilon (2e-4));
    CHECK ((a.eigenvalues.array() / b.eigenvalues.array()).sqrt().minCoeff() == Approx (1).epsilon (2e-4));
}

TEST_CASE ("A ring with hardly a hole is nearly a disc, and moves no mode with nodal diameters", "[immersed][plate]")
{
    auto problem = problemWithDisc ({}, { 0, 0 });
    const auto disc = bendingModes (problem, 12, resolutionFor (problem, 12, ModeAccuracy::usual));
    auto ring = ringPatch ({ 0, 0 }, 0.01, 0.0005);
    ring.added = problem.patches[0].added;
    ring.moment = problem.patches[0].moment;
    problem.patches = { ring };
    auto resolution = resolutionFor (problem, 12, ModeAccuracy::usual);
    const auto modes = bendingModes (problem, 12, resolution);

    for (Eigen::Index k = 0; k < 12; ++k)
        CHECK (std::sqrt (modes.eigenvalues[k] / disc.eigenvalues[k]) == Approx (1).epsilon (3e-3));
}
