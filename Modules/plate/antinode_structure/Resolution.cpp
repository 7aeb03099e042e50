#include "Resolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using std::numbers::pi;

/** What edges take from the area's share of modes, in units of length times k / (4 pi). */
double edgeTerms (const BendingProblem& problem)
{
    double sum = 0;

    for (const auto& path : problem.outline.paths)
        for (const auto& piece : path)
        {
            const auto& support = problem.edges[static_cast<std::size_t> (piece.edge)];
            const auto isHeld = support.holdsDisplacement || support.translation > 0;
            const auto isClamped = isHeld && (support.holdsSlope || support.rotation > 0);
            sum += piece.length (piece.from, piece.to) * (isClamped ? 1.8 : isHeld ? 1.0 : 0.0);
        }

    return sum;
}

/** The greatest ratio of a patch's wave number to that of the plate. */
double shortestWaves (const BendingProblem& problem)
{
    double ratio = 1;

    for (const auto& patch : problem.patches)
    {
        const auto mass = 1 + patch.added.massPerArea / problem.section.massPerArea;
        const auto stiffness = 1
                               + (patch.added.stiffness (0, 0) + (patch.bonded ? patch.bonded->stiffness (0, 0) : 0))
                                     / problem.section.stiffness (0, 0);
        ratio = std::max (ratio, std::pow (mass / stiffness, 0.25));
    }

    return ratio;
}
} // namespace

double expectedWaveNumber (const BendingProblem& problem, int count)
{
    const auto& d = problem.section.stiffness;
    const auto softer = std::min (d (0, 0), d (1, 1));

    // Of waves along the softer direction; those of other directions are longer.
    const auto area = areaOf (problem.outline) * std::sqrt (softer / std::sqrt (d (0, 0) * d (1, 1)));
    const auto edges = edgeTerms (problem);
    return (edges / 2 + std::sqrt (edges * edges / 4 + 16 * pi * area * (count + 1))) / (2 * area);
}

ImmersedResolution resolutionFor (const BendingProblem& problem, int count, ModeAccuracy accuracy)
{
    constexpr int resolvedModes = 20; // At least: then few modes are right to many digits, and still cost little.
    const auto wavelength =
        2 * pi / (expectedWaveNumber (problem, std::max (count, resolvedModes)) * shortestWaves (problem));
    const auto isHigh = accuracy == ModeAccuracy::high;
    const auto isHeld =
        std::any_of (problem.edges.begin(), problem.edges.end(),
                     [] (const EdgeSupport& edge) { return edge.holdsDisplacement || edge.holdsSlope; });
    ImmersedResolution resolution;
    resolution.cell = (isHeld ? 0.105 : 0.17) * (isHigh ? 0.7 : 1) * wavelength;
    resolution.holeCell = isHigh ? 0.2 : 0.3;
    resolution.patchCell = isHigh ? 0.05 : 0.08;
    return resolution;
}
} // namespace antinode
