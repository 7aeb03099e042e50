#include "TrackSolver.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
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

namespace
{
constexpr int maximumTrackSteps = 30; // of Newton

/** The length at which the dual, concave along a line, is highest: doubled while it rises, then bisected. */
double highestAlong (const LimitedDual& dual, const TrackPoint& point, const Eigen::MatrixXd& step,
                     const Eigen::MatrixXd& change)
{
    constexpr double longest = 64, flat = 0.1;
    constexpr int bisections = 12;
    const auto enough = flat * dual.slopeAlong (point, step, change, 0);
    double low = 0, high = 1, slope = dual.slopeAlong (point, step, change, high);

    while (slope > enough && high < longest)
    {
        low = high;
        high *= 2;
        slope = dual.slopeAlong (point, step, change, high);
    }

    for (int i = 0; i < bisections && std::abs (slope) > enough; ++i)
    {
        const auto middle = (low + high) / 2;
        slope = dual.slopeAlong (point, step, change, middle);
        (slope > 0 ? low : high) = middle;
    }

    return std::abs (slope) > enough ? low : high;
}
} // namespace

GradientsResult solveByGradients (WindowedResponses& responses, const Eigen::MatrixXd& free,
                                  const Eigen::MatrixXd& right, double tolerance, int most)
{
    GradientsResult result { Eigen::MatrixXd::Zero (right.rows(), right.cols()),
                             Eigen::MatrixXd::Zero (free.rows(), free.cols()), right };
    auto& residual = result.left;
    Eigen::MatrixXd preconditioned = responses.precondition (residual), direction = preconditioned;
    auto rise = product (residual, preconditioned);

    for (; result.iterations < most && residual.norm() > tolerance; ++result.iterations)
    {
        checkWatch();
        const auto pulls = responses.pulls (direction);
        const Eigen::MatrixXd image = responses.motion (pulls.cwiseProduct (free)) + responses.compliance() * direction;
        const auto step = rise / product (direction, image);
        result.solution += step * direction;
        result.pulls += step * pulls;
        residual -= step * image;
        preconditioned = responses.precondition (residual);
        const auto next = product (residual, preconditioned);
        direction = preconditioned + next / rise * direction;
        rise = next;
    }

    return result;
}

LimitedDual::LimitedDual (WindowedResponses& responsesToUse, const Eigen::MatrixXd& wantedToUse,
                          const Eigen::VectorXd& limits)
    : responses (responsesToUse), wanted (wantedToUse),
      bounds (limits.transpose().replicate (responsesToUse.windowLength(), 1))
{
}

TrackPoint LimitedDual::pointAt (Eigen::MatrixXd multipliers, Eigen::MatrixXd pulls) const
{
    TrackPoint point { std::move (multipliers), std::move (pulls), {}, {} };
    point.voltages = clipped (point.pulls);
    point.slope = wanted - responses.motion (point.voltages) - responses.compliance() * point.multipliers;
    return point;
}

double LimitedDual::value (const TrackPoint& point) const
{
    return product (wanted, point.multipliers) - responses.compliance() / 2 * point.multipliers.squaredNorm()
           - product (point.voltages, point.pulls) + point.voltages.squaredNorm() / 2;
}

double LimitedDual::slopeAlong (const TrackPoint& point, const Eigen::MatrixXd& step, const Eigen::MatrixXd& change,
                                double length) const
{
    return product (wanted, step)
           - responses.compliance() * (product (point.multipliers, step) + length * step.squaredNorm())
           - product (clipped (point.pulls + length * change), change);
}

double LimitedDual::errorBound (const TrackPoint& point) const
{
    const auto most = product (bounds, point.pulls.cwiseAbs());
    const auto scale = point.multipliers.norm() * wanted.norm();
    return scale > 0 ? std::max (0.0, (product (wanted, point.multipliers) - most) / scale) : 0;
}

Eigen::MatrixXd LimitedDual::missing (const TrackPoint& point) const
{
    return point.slope + responses.compliance() * point.multipliers;
}

Eigen::MatrixXd LimitedDual::freeSamples (const TrackPoint& point) const
{
    return (point.pulls.cwiseAbs().array() < bounds.array()).cast<double>();
}

void climbLimited (WindowedResponses& responses, const LimitedDual& dual, LimitedClimb& climb, double tolerance,
                   double uselessError)
{
    constexpr double coarse = 0.1; // of the slope: how well a step is solved
    auto& point = climb.point;
    point = dual.pointAt (point.multipliers, point.pulls);
    const auto enough = tolerance * dual.size();

    for (int i = 0; i < maximumTrackSteps && point.slope.norm() > enough && climb.errorBound <= uselessError; ++i)
    {
        const auto step = solveByGradients (responses, dual.freeSamples (point), point.slope,
                                            std::max (coarse * point.slope.norm(), enough / 2));
        climb.iterations += step.iterations;
        const auto length = highestAlong (dual, point, step.solution, step.pulls);
        point = dual.pointAt (point.multipliers + length * step.solution, point.pulls + length * step.pulls);
        climb.errorBound = std::max (climb.errorBound, dual.errorBound (point));
    }
}
} // namespace antinode
