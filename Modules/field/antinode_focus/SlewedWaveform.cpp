#include "SlewedWaveform.h"

#include "LimitError.h"
#include "LimitWords.h"
#include "SmoothEdges.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace antinode
{
namespace
{
/** How much of the slew limits a waveform uses. */
LimitUse slewOf (const WaveformTask& task, const SampledVoltages& voltages)
{
    VoltageProgram program;
    program.voltageLimits = task.limits;
    program.focusTime = task.description.focusTime;
    program.samples = voltages;
    return *limitUses (task.model, task.description.allocation, program).slew;
}

[[noreturn]] void throwTooSlow (const WaveformTask& task, const LimitUse& use)
{
    const auto peakVelocity = largestVelocity (task.description), reachable = peakVelocity / use.share();
    throw LimitError (limitField (use.kind),
                      "is " + limitAmount (use.kind, use.allowed) + ", too low for " + inWords (peakVelocity * 1000)
                          + " mm/s with free samples: " + limitedCeramic (task.model, use) + " needs "
                          + limitAmount (use.kind, use.used) + "; this limit allows " + inWords (reachable * 1000)
                          + " mm/s",
                      task.limits.maxCoeff(), reachable);
}

/** The time in which the slowest ceramic gets from 0 to its peak, s. */
double slowestRise (const Eigen::MatrixXd& values, const Eigen::VectorXd& slewLimits)
{
    double longest = 0;

    for (Eigen::Index i = 0; i < slewLimits.size(); ++i)
        if (slewLimits[i] > 0)
            longest = std::max (longest, values.row (i).cwiseAbs().maxCoeff() / slewLimits[i]);

    return longest;
}

/** The largest share of the slew limits around each free sample. N_b x N_s */
Eigen::MatrixXd slewShares (const SolvedWaveform& solved, const Eigen::VectorXd& slewLimits, double focusTime)
{
    const auto slopes = slopesOf (solved.waveform.played);
    const auto& sparse = solved.problem.sparse;
    const auto freeRate = sparse.freeRate();
    const auto columns = solved.problem.all.weights.cols();
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero (slewLimits.size(), columns);
    const auto interval = (slopes.last - slopes.first) / static_cast<double> (slopes.values.cols() - 1);

    for (Eigen::Index m = 0; m < slopes.values.cols(); ++m)
    {
        const auto before = focusTime - slopes.first - static_cast<double> (m) * interval;
        const auto n = sparse.range.focus - static_cast<Eigen::Index> (std::llround (std::abs (before) * freeRate));

        for (auto k = std::max<Eigen::Index> (n - 1, 0); k <= std::min (n + 1, columns - 1); ++k)
            for (Eigen::Index i = 0; i < slewLimits.size(); ++i)
                if (slewLimits[i] > 0)
                    shares (i, k) = std::max (shares (i, k), std::abs (slopes.values (i, m)) / slewLimits[i]);
    }

    return shares;
}

/** Lowers the free samples where what is played is too steep. */
void lowerWhereSteep (SolvedWaveform& solved, const Eigen::MatrixXd& steep, double room)
{
    constexpr double least = 0.02; // of the limit
    auto& all = solved.problem.all;

    if (all.shares.size() == 0)
        all.shares = Eigen::MatrixXd::Ones (steep.rows(), steep.cols());

    for (Eigen::Index n = 0; n < steep.cols(); ++n)
        for (Eigen::Index i = 0; i < steep.rows(); ++i)
            if (steep (i, n) > 1)
            {
                const auto used = std::abs (solved.waveform.free.samples (i, n)) / all.limits[i];
                all.shares (i, n) =
                    std::max (least * solved.waveform.peak, std::min (all.shares (i, n), used) / (room * steep (i, n)));
            }
}

/** Free samples are lowered where they are too steep, attempt by attempt. @return  none where that does not end */
std::optional<SolvedWaveform> solvedWithinSlews (const WaveformTask& task, const Eigen::VectorXd& slewLimits,
                                                 double edgeTime)
{
    constexpr int attempts = 20;
    constexpr double hopeless = 1.25, firstRoom = 1.01, moreRoom = 0.002;
    auto solved = solveWithEdges (task, edgeTime);
    const auto bound = solved.waveform.free.peakBound;
    auto best = std::numeric_limits<double>::infinity();

    for (int attempt = 0; attempt < attempts && solved.waveform.free.isMet; ++attempt)
    {
        solved.waveform.played = withSlowEnd (solved.waveform.played, slewLimits, task.description.focusTime);
        // Of waveforms with lowered samples the multipliers prove less.
        solved.waveform.free.peakBound = bound;

        const auto share = slewOf (task, solved.waveform.played).share();

        if (share <= 1)
            return solved;

        // The rows want steeper edges than these: lowered samples only make others steeper.
        if (share > hopeless * best)
            break;

        best = std::min (best, share);

        lowerWhereSteep (solved, slewShares (solved, slewLimits, task.description.focusTime),
                         firstRoom + moreRoom * attempt);
        solved.problem.all.start = solved.waveform.free.multipliers;
        solved.waveform = solvePlayed (solved.problem);
    }

    return {};
}
} // namespace

std::pair<SolvedWaveform, double> solveWithinSlews (const WaveformTask& task)
{
    constexpr double longer = 1.6, mostOfAll = 0.5; // of the time before the focus
    const auto slewLimits = antinode::slewLimits (task.model);
    auto free = solveWithEdges (task, 0);
    free.waveform.played = withSlowEnd (free.waveform.played, slewLimits, task.description.focusTime);
    const auto use = slewOf (task, free.waveform.played);

    if (use.share() <= 1)
        return { std::move (free), 0.0 };

    // Longer edges where shorter ones do not lead there.
    const auto sample = 1 / free.problem.sparse.freeRate();
    auto edge = std::max (slowestRise (free.waveform.played.values, slewLimits), sample);

    while (edge < mostOfAll * task.description.focusTime)
    {
        if (auto solved = solvedWithinSlews (task, slewLimits, edge))
            return { std::move (*solved), edge };

        edge *= longer;
    }

    throwTooSlow (task, use);
}
} // namespace antinode
