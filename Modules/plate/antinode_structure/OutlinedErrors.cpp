#include "OutlinedErrors.h"

#include <algorithm>

namespace antinode
{
namespace
{
/** Cells by a factor larger everywhere: those at corners are shares of the largest. */
ImmersedResolution coarserThan (ImmersedResolution resolution)
{
    constexpr double factor = 1.4;
    resolution.cell *= factor;
    resolution.holeCell *= factor;
    resolution.patchCell *= factor;
    return resolution;
}

/** What Nitsche's penalty leaves on cells of any size: measured, Docs/Design/outlines.md. */
double leftByPenalty (const BendingProblem& problem)
{
    constexpr double rounding = 1e-9, ofDisplacement = 2e-8, ofSlope = 5e-7;
    double left = rounding;

    for (const auto& edge : problem.edges)
        left = std::max (left, edge.holdsSlope ? ofSlope : edge.holdsDisplacement ? ofDisplacement : rounding);

    return left;
}
} // namespace

Eigen::VectorXd frequencyErrors (const OutlinedSolution& solution)
{
    const auto& fine = solution.modes.eigenvalues;
    const auto coarse =
        bendingModes (solution.scaled.problem, static_cast<int> (fine.size()), coarserThan (solution.resolution))
            .eigenvalues;
    const auto differences = (coarse.cwiseQuotient (fine).cwiseSqrt().array() - 1).abs();
    return (differences + leftByPenalty (solution.scaled.problem)).matrix();
}
} // namespace antinode
