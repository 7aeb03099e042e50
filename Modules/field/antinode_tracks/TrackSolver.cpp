#include "TrackSolver.h"

#include "TrackClimb.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr double trackTolerance = 1e-4; // of the wanted motion: -80 dB
constexpr double roughly = 1e-2;        // on the way there

TrackSolution solutionAt (WindowedResponses& responses, const Eigen::MatrixXd& wanted, const TrackPoint& point)
{
    TrackSolution solution;
    const Eigen::MatrixXd missing = point.slope + responses.compliance() * point.multipliers;
    solution.voltages = point.voltages;
    solution.multipliers = point.multipliers;
    solution.error = missing.norm() / wanted.norm();
    solution.objective = point.voltages.squaredNorm() / 2 + missing.squaredNorm() / (2 * responses.compliance());
    return solution;
}
} // namespace

TrackSolution solveTracks (WindowedResponses& responses, const Eigen::MatrixXd& wanted)
{
    const Eigen::MatrixXd free = Eigen::MatrixXd::Ones (responses.windowLength(), responses.actuators());
    auto found = solveByGradients (responses, free, wanted, trackTolerance * wanted.norm());
    TrackPoint point { std::move (found.solution), std::move (found.pulls), {}, {} };
    point.voltages = point.pulls;
    point.slope = wanted - responses.motion (point.voltages) - responses.compliance() * point.multipliers;
    auto solution = solutionAt (responses, wanted, point);
    solution.bound = product (wanted, point.multipliers) - responses.compliance() / 2 * point.multipliers.squaredNorm()
                     - point.pulls.squaredNorm() / 2;
    solution.iterations = found.iterations;
    return solution;
}

TrackSolution solveLimitedTracks (WindowedResponses& responses, const Eigen::MatrixXd& wanted,
                                  const Eigen::VectorXd& limits, const Eigen::MatrixXd& start, double uselessError)
{
    const auto compliance = responses.compliance();
    const LimitedDual dual (responses, wanted, limits);
    LimitedClimb climb { dual.pointAt (start, responses.pulls (start)) };
    climb.errorBound = dual.errorBound (climb.point);

    for (const auto softer : { 1e4, 1e3, 1e2, 1e1, 1.0 })
        if (climb.errorBound <= uselessError)
        {
            responses.setCompliance (softer * compliance);
            climbLimited (responses, dual, climb, softer > 1 ? roughly : trackTolerance, uselessError);
        }

    responses.setCompliance (compliance);
    climb.point = dual.pointAt (climb.point.multipliers, climb.point.pulls);
    auto solution = solutionAt (responses, wanted, climb.point);
    solution.bound = dual.value (climb.point);
    solution.errorBound = climb.errorBound;
    solution.iterations = climb.iterations;
    return solution;
}

double peakBound (WindowedResponses& responses, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                  const Eigen::MatrixXd& multipliers, double error)
{
    const auto price = (responses.pulls (multipliers).cwiseAbs() * limits).sum();
    const auto worth = product (wanted, multipliers) - error * wanted.norm() * multipliers.norm();
    return price > 0 ? std::max (0.0, worth / price) : 0;
}
} // namespace antinode
