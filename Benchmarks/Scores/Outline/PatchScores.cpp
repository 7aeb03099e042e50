#include "ScoreTools.h"

namespace antinode::scores
{
OutlineScore turnedSquares (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "a square of a ceramic, turned, 20 modes, against smaller cells" };

    for (int i = 0; i < cases; ++i)
    {
        const auto sizeY = random.between (0.5, 1), width = random.between (0.1, 0.2);
        auto problem = unitPlate (0.3, { rectanglePath ({ 0.5, sizeY / 2 }, { 1, sizeY }, 0, { 0, 0, 0, 0 }, 0) },
                                  { 4, i % 2 == 0 ? supportedEdge : freeEdge });
        auto square = rectanglePatch ({ random.between (0.2, 0.8), random.between (0.2, sizeY - 0.2) },
                                      { width, width * random.between (0.6, 1) }, random.between (0.05, pi / 2 - 0.05));
        square.added = randomCeramic (random);
        square.moment << 1, 1, 0;
        problem.patches = { square };
        const auto resolution = resolutionFor (problem, 20, ModeAccuracy::usual);
        const auto modes = timed (score, problem, 22, resolution);
        const auto reference = bendingModes (problem, 22, smaller (resolution, 0.5));
        note (score.frequencyError, frequencyError (modes, reference));
        note (score.participationError, participationError (modes, reference));
    }

    return score;
}

OutlineScore reentrantCorners (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "L and notches, 12 modes, against cells of a half" };

    for (int i = 0; i < cases; ++i)
    {
        const auto x = random.between (0.3, 0.6), y = random.between (0.3, 0.6), end = x + random.between (0.1, 0.3);
        const auto corners =
            i % 2 == 0 ? std::vector<Eigen::Vector2d> { { 0, 0 }, { 1, 0 }, { 1, y }, { x, y }, { x, 1 }, { 0, 1 } }
                       : std::vector<Eigen::Vector2d> { { 0, 0 },   { 1, 0 }, { 1, 0.7 }, { end, 0.7 },
                                                        { end, y }, { x, y }, { x, 0.7 }, { 0, 0.7 } };
        auto problem =
            unitPlate (random.between (0.1, 0.4), { polygonPath (corners, 0) }, { corners.size(), freeEdge });

        if (i % 4 > 1)
            problem.edges.back() = clampedEdge;

        const auto resolution = resolutionFor (problem, 20, ModeAccuracy::usual);
        const auto modes = timed (score, problem, 12, resolution);
        note (score.frequencyError, frequencyError (modes, bendingModes (problem, 12, smaller (resolution, 0.5))));
    }

    return score;
}

OutlineScore eightPatches (unsigned seed, bool areDiscs)
{
    Random random (seed);
    OutlineScore score { areDiscs ? "eight discs on a rounded rectangle, 50 modes, against smaller cells"
                                  : "eight turned squares on it, 50 modes, against smaller cells" };
    auto problem = unitPlate (0.22, { rectanglePath ({ 0.5, 0.35 }, { 1, 0.7 }, 0, { 0.05, 0.05, 0.05, 0.05 }, 0) },
                              { 4, freeEdge });
    const auto added = randomCeramic (random);

    for (int i = 0; i < 8; ++i)
    {
        const Eigen::Vector2d centre (0.14 + 0.24 * (i % 4) + random.between (-0.03, 0.03),
                                      (i < 4 ? 0.17 : 0.53) + random.between (-0.03, 0.03));
        auto patch =
            areDiscs ? discPatch (centre, 0.06) : rectanglePatch (centre, { 0.11, 0.11 }, random.between (0.1, 1.4));
        patch.added = added;
        patch.moment << 1, 1, 0;
        problem.patches.push_back (patch);
    }

    // Of the last two modes only what they share with those before is scored.
    constexpr int solved = 52;
    const auto resolution = resolutionFor (problem, solved, ModeAccuracy::usual);
    const auto modes = timed (score, problem, solved, resolution);
    const auto reference = bendingModes (problem, solved, smaller (resolution, 0.75));
    note (score.frequencyError, frequencyError (modes, reference));
    note (score.participationError, participationError (modes, reference));
    return score;
}
} // namespace antinode::scores
