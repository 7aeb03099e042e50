#include "BoundedWaveform.h"

#include "MinimumPeak.h"
#include "WaveformDual.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto rowTolerance = 1e-12;     // aimed at
constexpr auto acceptedResidual = 1e-10; // taken where rounding leaves no less
constexpr auto maximumWaveformSteps = 40;

/** Where a solution stands. */
struct DualPoint
{
    Eigen::VectorXd multipliers, slope; // slope of the dual: what the rows miss
    Eigen::MatrixXd pulls;
};

DualPoint pointAt (const WaveformDual& dual, Eigen::VectorXd y, Eigen::MatrixXd pulls)
{
    const Eigen::VectorXd slope =
        dual.wanted - dual.rowValues (dual.clipped (pulls)) - dual.compliance.cwiseProduct (y);
    return { std::move (y), slope, std::move (pulls) };
}

/** The Newton step; the curvature is lifted until it can be factored and leads upwards. */
Eigen::VectorXd newtonStep (const WaveformDual& dual, const DualPoint& point, FreeGrams& seen)
{
    const auto curvature = dual.curvature (point.pulls, seen);

    for (auto lift = 1e-13;; lift *= 100)
    {
        Eigen::MatrixXd factor = curvature;
        factor.diagonal().array() += lift;

        if (! factorLower (factor))
            continue;

        Eigen::MatrixXd step = point.slope;
        solveLower (factor, step);
        solveLowerTransposed (factor, step);

        if (step.allFinite() && step.col (0).dot (point.slope) > 0)
            return step;

        if (lift > 1)
            return point.slope;
    }
}

/** The length at which the dual, concave along a line, is highest: doubled while it rises, then bisected. */
double bestLength (const WaveformDual& dual, const DualPoint& point, const Eigen::VectorXd& step,
                   const Eigen::MatrixXd& change)
{
    constexpr auto longest = 1024.0;
    constexpr auto bisections = 12;
    constexpr auto flat = 0.05; // of the slope at the start: as good as the highest
    const auto slopeAt = [&] (double length)
    {
        const Eigen::MatrixXd pulls = point.pulls + length * change;
        return dual.wanted.dot (step) - dual.clipped (pulls).cwiseProduct (change).sum()
               - dual.compliance.cwiseProduct (point.multipliers + length * step).dot (step);
    };
    const auto enough = flat * point.slope.dot (step);
    double low = 0, high = 1;
    auto slope = slopeAt (high);

    while (slope > enough && high < longest)
    {
        low = high;
        high *= 2;
        slope = slopeAt (high);
    }

    for (int i = 0; i < bisections && slope < -enough; ++i)
    {
        const auto middle = 0.5 * (low + high);
        const auto between = slopeAt (middle);

        if (between < -enough)
            high = middle;
        else if (between > enough)
            low = middle;
        else
            return middle;
    }

    return slope < -enough ? 0.5 * (low + high) : high;
}

/** max |row error| / max |wanted| of the hard rows, as they were before they were scaled. */
double worstHardRow (const WaveformDual& dual, const Eigen::VectorXd& slope)
{
    double worst = 0, largest = 0;

    for (Eigen::Index k = 0; k < slope.size(); ++k)
        if (dual.compliance[k] == 0 && dual.scale[k] > 0)
        {
            worst = std::max (worst, std::abs (slope[k]) / dual.scale[k]);
            largest = std::max (largest, std::abs (dual.wanted[k]) / dual.scale[k]);
        }

    return largest > 0 ? worst / largest : worst;
}

/** What multipliers of the hard rows alone prove: wanted' y / sum_i sum_n cap (i, n) |pull|. */
double computePeakBound (const WaveformDual& dual, const Eigen::VectorXd& y)
{
    const Eigen::VectorXd hard = (dual.compliance.array() == 0).select (y, 0.0);
    const auto price = dual.computePulls (hard).cwiseAbs().cwiseProduct (dual.caps).sum();
    return price > 0 ? std::max (0.0, dual.wanted.dot (hard) / price) : 0;
}

/** Where the dual is highest, or far enough on a way without end to prove that there is one. */
struct DualSummit
{
    DualPoint point;
    double residual = 0;
    double peakBound = 0;
    int iterations = 0;
};

DualSummit climb (const WaveformDual& dual, const Eigen::VectorXd& start, FreeGrams& seen)
{
    DualSummit summit;
    summit.point = pointAt (dual, start, dual.computePulls (start));
    auto& point = summit.point;
    const auto look = [&]
    {
        summit.residual = worstHardRow (dual, point.slope);
        summit.peakBound = std::max (summit.peakBound, computePeakBound (dual, point.multipliers));
    };
    const auto isOpen = [&]
    { return summit.residual > rowTolerance || point.slope.norm() > rowTolerance * dual.wanted.norm(); };
    look();

    for (; isOpen() && summit.peakBound <= 1 && summit.iterations < maximumWaveformSteps; ++summit.iterations)
    {
        const auto step = newtonStep (dual, point, seen);
        const auto change = dual.computePulls (step);
        const Eigen::VectorXd next = point.multipliers + bestLength (dual, point, step, change) * step;
        point = pointAt (dual, next, dual.computePulls (next));
        look();
    }

    return summit;
}

/** The multipliers that would do without limits. */
Eigen::VectorXd unlimitedMultipliers (const WaveformDual& dual, FreeGrams& seen)
{
    const Eigen::VectorXd none = Eigen::VectorXd::Zero (dual.wanted.size());
    return newtonStep (dual, { none, dual.wanted, dual.computePulls (none) }, seen);
}

/** Lowers the caps to so many times the peak bound that is known, which each attempt makes tighter, until they are
   kept.
    @return  the summit, its bound in terms of the caps as they were, and the share of them that is left */
std::pair<DualSummit, double> climbNearBound (WaveformDual& dual, const Eigen::VectorXd& start, double nearness,
                                              FreeGrams& seen)
{
    constexpr auto leastRise = 1.02; // where an attempt proves nothing new
    auto bound = computePeakBound (dual, start);
    auto share = std::min (1.0, nearness * bound);
    dual.caps *= share;

    for (;;)
    {
        auto summit = climb (dual, start, seen);
        bound = std::max (bound, share * summit.peakBound);

        if (summit.residual <= acceptedResidual || share == 1)
        {
            summit.peakBound = bound;
            return { summit, share };
        }

        const auto next = std::min (1.0, std::max (nearness * bound, leastRise * share));
        dual.caps *= next / share;
        share = next;
    }
}
} // namespace

BoundedWaveform solveBoundedWaveform (const BoundedWaveformProblem& problem)
{
    WaveformDual dual (problem);
    auto seen = dual.freeGrams();
    const Eigen::VectorXd start = problem.start.size() > 0 ? Eigen::VectorXd (problem.start.cwiseQuotient (dual.scale))
                                                           : unlimitedMultipliers (dual, seen);
    const auto [summit, share] = problem.nearness > 0 ? climbNearBound (dual, start, problem.nearness, seen)
                                                      : std::pair (climb (dual, start, seen), 1.0);
    const auto& point = summit.point;
    BoundedWaveform result;
    result.limitShare = share;
    const auto scaled = dual.clipped (point.pulls);
    result.samples = scaled * dual.roots.cwiseInverse().asDiagonal();
    result.multipliers = dual.scale.cwiseProduct (point.multipliers);
    result.rowResidual = summit.residual;
    result.isMet = summit.residual <= acceptedResidual;
    result.bound = dual.value (point.multipliers, point.pulls);
    result.objective = dual.objective (scaled);
    result.peakBound = summit.peakBound;
    result.iterations = summit.iterations;
    return result;
}

double provenPeak (const BoundedWaveformProblem& problem, const Eigen::VectorXd& multipliers)
{
    const WaveformDual dual (problem);
    return computePeakBound (dual, multipliers.cwiseQuotient (dual.scale));
}

PeakBracket minimumWaveformPeak (const BoundedWaveformProblem& problem, double tolerance)
{
    MinimumPeakProblem peak;
    peak.wanted = problem.wanted;
    const auto weights = std::make_shared<const Eigen::MatrixXd> (problem.weights);

    for (Eigen::Index i = 0; i < problem.limits.size(); ++i)
        peak.ceramics.push_back ({ problem.participation.col (i) * problem.limits[i], weights });

    const auto found = minimumPeak (peak, tolerance / (1 + tolerance));
    return { found.lower, found.upper, found.multipliers };
}
} // namespace antinode
