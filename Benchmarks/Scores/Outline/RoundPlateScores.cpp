#include "ScoreTools.h"

namespace antinode::scores
{
OutlineScore roundPlates (int cases, unsigned seed, ModeAccuracy accuracy)
{
    Random random (seed);
    OutlineScore score { accuracy == ModeAccuracy::usual ? "circles and rings, any edges, 50 modes, usual cells"
                                                         : "the same on request" };

    for (int i = 0; i < cases; ++i)
    {
        const auto hole = i % 2 == 0 ? 0 : random.between (0.05, 0.8);
        const auto inner = randomEdge (random), outer = randomEdge (random);
        const auto ratio = random.between (0.05, 0.45);
        std::vector<ClosedPath> paths { circlePath ({ random.between (0, 1), random.between (0, 1) }, 1, 0) };

        if (hole > 0)
            paths.push_back (circlePath (paths[0][0].centre, hole, 1));

        const auto problem = unitPlate (ratio, paths, { supportOf (outer), supportOf (inner) });
        const auto modes = timed (score, problem, 50, resolutionFor (problem, 50, accuracy));
        const tests::CircularPlate exact { hole, { { 1, 1, ratio, 1 } }, inner, outer };
        note (score, deviationFrom (frequencies (modes), exact),
              { hole, ratio, inner.translation, inner.rotation, outer.translation, outer.rotation });
    }

    return score;
}

OutlineScore shiftedAndTurned (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "rounded rectangles with a hole, shifted and turned, 30 modes" };
    const auto support = std::array { freeEdge, supportedEdge, clampedEdge };

    for (int i = 0; i < cases; ++i)
    {
        const auto sizeY = random.between (0.4, 1), radius = random.between (0.05, 0.15),
                   ratio = random.between (0.1, 0.4);
        const auto& edge = support[static_cast<std::size_t> (i % 3)];
        auto problem =
            unitPlate (ratio,
                       { rectanglePath ({ 0.5, sizeY / 2 }, { 1, sizeY }, 0, { radius, radius, radius, radius }, 0),
                         circlePath ({ random.between (0.3, 0.7), sizeY / 2 }, random.between (0.03, 0.1), 4) },
                       { edge, edge, edge, edge, freeEdge });
        const auto straight = bendingModes (problem, 30, resolutionFor (problem, 30, ModeAccuracy::high));
        problem.outline =
            moved (problem.outline, random.between (0, 2 * pi), { random.between (0, 1), random.between (0, 1) });
        auto resolution = resolutionFor (problem, 30, ModeAccuracy::usual);
        resolution.offset = random.between (0.01, 0.99);
        const auto modes = timed (score, problem, 30, resolution);

        if (modes.rigidBodyModes != (i % 3 == 0 ? 3 : 0))
            throw std::runtime_error ("a rigid motion is missing or false");

        note (score.frequencyError, frequencyError (modes, straight));
    }

    return score;
}

OutlineScore plateaus (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "a disc of a ceramic amid a circle, 50 modes" };

    for (int i = 0; i < cases; ++i)
    {
        const auto radius = random.between (0.08, 0.3);
        const auto outer =
            i % 2 == 0 ? tests::CircularEdge {} : tests::CircularEdge { tests::rigid, i % 4 == 1 ? 0 : tests::rigid };
        const tests::PlateRing inner { radius, random.between (2, 8), random.between (0.1, 0.4),
                                       random.between (1.5, 4) };
        const Eigen::Vector2d centre (random.between (0, 1), random.between (0, 1));
        auto problem = unitPlate (0.22, { circlePath (centre, 1, 0) }, { supportOf (outer) });
        auto disc = discPatch (centre, radius);
        disc.added = less (isotropicSection (inner.stiffness, inner.poissonRatio, inner.massPerArea), problem.section);
        disc.moment << 1, 1, 0;
        problem.patches = { disc };
        const auto modes = timed (score, problem, 50, resolutionFor (problem, 50, ModeAccuracy::usual));
        const tests::CircularPlate exact { 0, { inner, { 1, 1, 0.22, 1 } }, {}, outer };
        const auto expected = tests::circularModes (exact, 50);
        Eigen::VectorXd fluxes (50), found (50);

        for (Eigen::Index k = 0; k < 50; ++k)
        {
            const auto& mode = expected[static_cast<std::size_t> (k)];
            fluxes[k] =
                mode.diameters > 0 ? 0 : 2 * pi * radius * std::abs (slopeAtFirstRing (exact, mode.angularFrequency));
            note (
                score, std::abs (std::sqrt (modes.eigenvalues[k]) / mode.angularFrequency - 1),
                { radius, inner.stiffness, inner.poissonRatio, inner.massPerArea, outer.translation, outer.rotation });
        }

        // Of modes as close as their errors the sum counts.
        for (Eigen::Index k = 0; k < 50; ++k)
        {
            double sum = 0, exactSum = 0;

            for (Eigen::Index l = 0; l < 50; ++l)
                if (std::abs (expected[static_cast<std::size_t> (l)].angularFrequency
                                  / expected[static_cast<std::size_t> (k)].angularFrequency
                              - 1)
                    < 1e-3)
                {
                    sum += std::pow (modes.participation (l, 0), 2);
                    exactSum += fluxes[l] * fluxes[l];
                }

            note (score.participationError, std::abs (std::sqrt (sum) - std::sqrt (exactSum)) / fluxes.maxCoeff());
        }
    }

    return score;
}
} // namespace antinode::scores
