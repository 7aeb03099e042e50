#include "PlayedWaveform.h"

#include <algorithm>

namespace antinode
{
namespace
{
double peakShare (const Eigen::MatrixXd& samples, const Eigen::VectorXd& limits)
{
    return samples.cwiseAbs().rowwise().maxCoeff().cwiseQuotient (limits).maxCoeff();
}

/** The least peak that is proven, as a share of the limits. */
double provenShare (const PlayedProblem& problem, const BoundedWaveform& free, double lowered)
{
    if (! problem.everySample)
        return free.peakBound;

    const Eigen::VectorXd ofHardRows = free.multipliers.head (problem.hard.wanted.size());
    return std::min (free.peakBound / lowered, provenPeak (*problem.everySample, ofHardRows));
}
} // namespace

PlayedWaveform solvePlayed (const PlayedProblem& problem)
{
    constexpr int attempts = 6;
    constexpr double room = 1.002, nearest = 1.01, rounding = 1e-9;
    const auto nearness = problem.all.nearness;
    auto lowered = problem.all;
    PlayedWaveform result;
    double excess = 1;

    for (int attempt = 0; attempt < attempts && ! result.isNear; ++attempt)
    {
        lowered.limits = problem.all.limits / excess;
        lowered.nearness = nearness > 0 ? std::max (nearness / excess, nearest) : 0;
        result.free = solveBoundedWaveform (lowered);
        result.free.peakBound = provenShare (problem, result.free, excess);
        result.free.limitShare /= excess;

        if (! result.free.isMet)
            break;

        result.played = playedSamples (result.free.samples, problem.sparse, problem.focusTime);
        result.peak = peakShare (result.played.values, problem.all.limits);
        const auto allowed = nearness > 0 ? std::min (1.0, nearness * result.free.peakBound) : 1.0;
        result.isNear = problem.sparse.factor == 1 || result.peak <= allowed * (1 + rounding);
        excess *= room * std::max (1.0, result.peak / allowed);
    }

    return result;
}
} // namespace antinode
