#include "PlayedWaveform.h"

#include "SmoothEdges.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
double peakShare (const Eigen::MatrixXd& samples, const Eigen::VectorXd& limits)
{
    return samples.cwiseAbs().rowwise().maxCoeff().cwiseQuotient (limits).maxCoeff();
}

SampledVoltages played (const BoundedWaveform& waveform, const PlayedProblem& problem)
{
    return playedSamples (withSmoothEdges (waveform.samples, problem.edge), problem.sparse, problem.focusTime);
}

/** The free sample that a played one lies nearest to; those behind the focus are images of those before it. */
Eigen::Index nearestFree (const SparseSamples& sparse, Eigen::Index played)
{
    const auto focus = sparse.range.focus;
    const auto nearest = static_cast<Eigen::Index> (std::llround (sparse.placeOf (played)));
    return std::clamp<Eigen::Index> (nearest > focus ? 2 * focus - nearest : nearest, 0, focus);
}

/** Lowers the free samples where what is played between them is higher than allowed, and their neighbours. */
void lowerWhereHigh (Eigen::MatrixXd& shares, const PlayedProblem& problem, const Eigen::MatrixXd& played,
                     double allowed, double room)
{
    for (Eigen::Index i = 0; i < shares.rows(); ++i)
    {
        Eigen::VectorXd excess = Eigen::VectorXd::Ones (shares.cols());

        for (Eigen::Index m = 0; m < played.cols(); ++m)
        {
            auto& largest = excess[nearestFree (problem.sparse, m)];
            largest = std::max (largest, std::abs (played (i, m)) / (allowed * problem.all.limits[i]));
        }

        for (Eigen::Index n = 0; n < shares.cols(); ++n)
        {
            // A free sample moves what is played up to an edge later.
            const auto later = 2 + static_cast<Eigen::Index> (std::ceil (problem.edge));
            const auto first = std::max<Eigen::Index> (n - 1, 0);
            const auto around = excess.segment (first, std::min (n + later, shares.cols()) - first).maxCoeff();

            if (around > 1)
                shares (i, n) /= room * around;
        }
    }
}

/** The least peak of free samples that are as tolerant; 0 where nobody asks, or samples have limits of their own.
    @param proof  any multipliers */
double provenTolerant (const PlayedProblem& problem, const WaveformMultipliers& proof, const PlayedWaveform& waveform)
{
    const auto asks = problem.isRobust && problem.all.shares.size() == 0;
    return asks ? provenPeak (problem.all, proof, waveform.free.softCost) : 0;
}

/** As near to the bound as is asked for, between the free samples too, if the attempts lead there. */
PlayedWaveform solveBetween (const PlayedProblem& problem, BoundedWaveformSolver& solver, PlayedWaveform result)
{
    constexpr int attempts = 20;
    constexpr double rounding = 1e-9, firstRoom = 1.01, moreRoom = 0.003;
    const auto hard = problem.hard.wanted.size();
    const auto first = result.free.multipliers;
    auto shares = problem.all.shares;

    if (shares.size() == 0)
        shares.setOnes (problem.all.limits.size(), problem.all.weights.cols());

    double bound = 0;

    for (int attempt = 0; attempt < attempts && result.free.isMet; ++attempt)
    {
        // Of waveforms with lowered samples the multipliers prove no more than those of the first two.
        if (attempt < 2)
            bound = std::max (bound, provenPeak (*problem.everySample, result.free.multipliers.rows.head (hard)));

        result.played = played (result.free, problem);
        result.peak = peakShare (result.played.values, problem.all.limits);
        const auto allowed = std::min (1.0, problem.all.nearness * bound);
        result.free.peakBound = bound;
        result.free.limitShare = allowed;
        result.isNear = result.peak <= allowed * (1 + rounding);

        result.isLimited = attempt > 0 || result.isLimited;

        if (result.isNear)
            break;

        lowerWhereHigh (shares, problem, result.played.values, allowed, firstRoom + moreRoom * attempt);
        result.free = solver.solveWithin (allowed, shares, result.free.multipliers);
    }

    result.tolerantBound = provenTolerant (problem, first, result);
    return result;
}
} // namespace

PlayedWaveform solvePlayed (const PlayedProblem& problem)
{
    PlayedWaveform result;
    BoundedWaveformSolver solver (problem.all);
    result.free = solver.solve();

    if (! result.free.isMet)
        return result;

    constexpr double touching = 1 - 1e-9;
    result.isLimited = problem.all.shares.size() > 0
                       || peakShare (result.free.samples, problem.all.limits) >= touching * result.free.limitShare;

    if (! problem.sparse.ratio.isOne())
        return solveBetween (problem, solver, std::move (result));

    result.tolerantBound = provenTolerant (problem, result.free.multipliers, result);

    result.played = played (result.free, problem);
    result.peak = peakShare (result.played.values, problem.all.limits);
    result.isNear = true;
    return result;
}
} // namespace antinode
