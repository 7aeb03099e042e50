#include "BoundedWaveform.h"

#include "DualClimb.h"
#include "MinimumPeak.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto acceptedResidual = 1e-10; // taken where rounding leaves no less

/** Lowers the caps to so many times the peak bound that is known, which each attempt makes tighter, until they are
   kept.
    @return  the summit, its bound in terms of the caps as they were, and the share of them that is left */
std::pair<DualSummit, double> climbNearBound (WaveformDual& dual, DualClimb& climb, const WaveformMultipliers& start,
                                              const Eigen::MatrixXd& shares, double nearness)
{
    constexpr auto leastRise = 1.02; // where an attempt proves nothing new
    auto bound = computePeakBound (dual, start);
    auto share = std::min (1.0, nearness * bound);

    for (;;)
    {
        dual.limit (share, shares);
        auto summit = climb.from (start);
        bound = std::max (bound, share * summit.peakBound);

        if (summit.residual <= acceptedResidual || share == 1)
        {
            summit.peakBound = bound;
            return { summit, share };
        }

        share = std::min (1.0, std::max (nearness * bound, leastRise * share));
    }
}

BoundedWaveform described (const WaveformDual& dual, const DualSummit& summit, double share)
{
    const auto& point = summit.point;
    BoundedWaveform result;
    result.limitShare = share;
    const auto scaled = dual.clipped (point.pulls);
    result.samples = scaled * dual.roots.cwiseInverse().asDiagonal();
    result.multipliers = dual.unscaled (point.multipliers);
    result.rowResidual = summit.residual;
    result.isMet = summit.residual <= acceptedResidual;
    result.bound = dual.value (point.multipliers, point.pulls);
    result.softCost = dual.softCost (scaled);
    result.objective = 0.5 * scaled.squaredNorm() + result.softCost;
    result.peakBound = summit.peakBound;
    result.iterations = summit.iterations;
    return result;
}
} // namespace

struct BoundedWaveformSolver::Kept
{
    explicit Kept (const BoundedWaveformProblem& problemToSolve)
        : problem (problemToSolve), dual (problemToSolve), climb (dual)
    {
    }

    const BoundedWaveformProblem& problem;
    WaveformDual dual;
    DualClimb climb;
};

BoundedWaveformSolver::BoundedWaveformSolver (const BoundedWaveformProblem& problem)
    : kept (std::make_unique<Kept> (problem))
{
}

BoundedWaveformSolver::~BoundedWaveformSolver() = default;

BoundedWaveform BoundedWaveformSolver::solve()
{
    auto& [problem, dual, climb] = *kept;
    const auto start = problem.start.rows.size() > 0 ? dual.scaled (problem.start) : climb.unlimited();

    if (! (problem.nearness > 0))
        return described (dual, climb.from (start), 1);

    const auto [summit, share] = climbNearBound (dual, climb, start, problem.shares, problem.nearness);
    return described (dual, summit, share);
}

BoundedWaveform BoundedWaveformSolver::solveWithin (double limitShare, const Eigen::MatrixXd& shares,
                                                    const WaveformMultipliers& start)
{
    auto& dual = kept->dual;
    dual.limit (limitShare, shares);
    return described (dual, kept->climb.from (dual.scaled (start)), limitShare);
}

BoundedWaveform solveBoundedWaveform (const BoundedWaveformProblem& problem)
{
    return BoundedWaveformSolver (problem).solve();
}

double provenPeak (const BoundedWaveformProblem& problem, const Eigen::VectorXd& multipliers)
{
    const WaveformDual dual (problem);
    return computePeakBound (dual, dual.scaled ({ multipliers, {} }));
}

double provenPeak (const BoundedWaveformProblem& problem, const WaveformMultipliers& multipliers, double softCost)
{
    const WaveformDual dual (problem);
    return computePeakBound (dual, dual.scaled (multipliers), softCost);
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
