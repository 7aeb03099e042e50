#include "WaveformProblem.h"

#include "FreeSamples.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

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

namespace
{
/** A place of an error, in standard deviations, and its share. */
struct ErrorPlace
{
    double place, share;
};

/** Gauss and Hermite's rules for a normally distributed error. In their middle nothing is off. Of frequencies three
   points are too few: the phase of a lightly damped mode is off by more than a radian there, and free samples cancel at
   the points what they double between them. */
constexpr std::array<ErrorPlace, 3> frequencyNodes { ErrorPlace { 1.1544053947399682, 0.2401231786050127 },
                                                     ErrorPlace { 2.3667594107345416, 0.0307571239675865 },
                                                     ErrorPlace { 3.7504397177257425, 0.0005482688559722 } };
constexpr std::array<ErrorPlace, 1> dampingNodes { ErrorPlace { 1.7320508075688772, 1.0 / 6 } };

/** What costs less than so much of the energy that moves it does not shape the answer. */
constexpr double weakestCost = 1;

/** The same of each ceramic's own parts, of which many add up. */
constexpr double weakestOwnCost = 0.01;

/** Velocities per free sample, all of a device with errors. rows x N_s */
Eigen::MatrixXd weightsOff (const SampledRows& rows, double frequencyFactor, double dampingFactor)
{
    ModalModel off;
    off.angularFrequencies = rows.model.angularFrequencies * frequencyFactor;
    off.dampingRatios = (rows.model.dampingRatios * dampingFactor).cwiseMin (0.999);
    return velocityWeights (off, rows.modes, rows.sparse);
}

/** What errors of frequency and of damping change, each in both directions, by the roots of their shares. */
std::vector<Eigen::MatrixXd> changesOf (const SampledRows& rows, const DetuningSpread& spread,
                                        const Eigen::MatrixXd& known)
{
    std::vector<Eigen::MatrixXd> changes;
    const auto frequency = std::hypot (spread.frequency, spread.drift);

    for (const auto side : { -1, 1 })
    {
        if (frequency > 0)
            for (const auto& [place, share] : frequencyNodes)
                changes.emplace_back (std::sqrt (share) * (weightsOff (rows, 1 + side * place * frequency, 1) - known));

        if (spread.damping > 0)
            for (const auto& [place, share] : dampingNodes)
                changes.emplace_back (
                    std::sqrt (share)
                    * (weightsOff (rows, 1, std::max (0.01, 1 + side * place * spread.damping)) - known));
    }

    return changes;
}

/** Further rows of modes, and what each ceramic's part of them costs. */
struct SoftRows
{
    std::vector<Eigen::Index> of; ///< The row of the problem whose mode it is.
    Eigen::MatrixXd weights;      ///< As many rows.

    void add (Eigen::Index row, const Eigen::RowVectorXd& more)
    {
        const auto count = static_cast<Eigen::Index> (of.size());

        if (count == weights.rows())
            weights.conservativeResize (2 * count + 64, more.size());

        weights.row (count) = more;
        of.push_back (row);
    }
};

/** As few rows of a mode as have the expected squares of its changes. @param least  their squared length at least */
void addPrincipalRows (SoftRows& found, Eigen::Index row, const std::vector<Eigen::MatrixXd>& changes, double least)
{
    Eigen::MatrixXd stack (static_cast<Eigen::Index> (changes.size()), changes.front().cols());

    for (std::size_t c = 0; c < changes.size(); ++c)
        stack.row (static_cast<Eigen::Index> (c)) = changes[c].row (row);

    const auto eigen = symmetricEigen (stack * stack.transpose());

    for (Eigen::Index c = 0; c < eigen.values.size(); ++c)
        if (eigen.values[c] > least)
            found.add (row, eigen.vectors.col (c).transpose() * stack);
}

/** Only what is strong enough. */
Eigen::MatrixXd ownSpread (const BoundedWaveformProblem& problem, double size)
{
    const Eigen::VectorXd lengths = problem.weights.rowwise().norm();
    Eigen::MatrixXd spread = size * problem.participation.cwiseAbs();

    for (Eigen::Index i = 0; i < spread.cols(); ++i)
        for (Eigen::Index k = 0; k < spread.rows(); ++k)
            if (! (spread (k, i) * lengths[k] > std::sqrt (weakestOwnCost)))
                spread (k, i) = 0;

    return spread;
}
} // namespace

BoundedWaveformProblem withTolerance (BoundedWaveformProblem problem, const SampledRows& rows,
                                      const DetuningSpread& spread, double price)
{
    const auto known = problem.weights.rows();
    const auto changes = changesOf (rows, spread, problem.weights);
    SoftRows more;

    if (! changes.empty())
        for (Eigen::Index k = 0; k < known; ++k)
        {
            checkWatch();
            addPrincipalRows (more, k, changes, weakestCost / (price * problem.participation.row (k).squaredNorm()));
        }

    const auto count = static_cast<Eigen::Index> (more.of.size());
    const Eigen::MatrixXd participation = problem.participation (more.of, Eigen::all);
    problem.weights.conservativeResize (known + count, Eigen::NoChange);
    problem.weights.bottomRows (count) = more.weights.topRows (count);
    problem.participation.conservativeResize (known + count, Eigen::NoChange);
    problem.participation.bottomRows (count) = participation;
    problem.wanted.conservativeResize (known + count);
    problem.wanted.tail (count).setZero();

    // Of guards, which want 0, all of the velocity is an error.
    for (auto& compliance : problem.compliance)
        if (compliance > 0)
            compliance = 1 / (1 / compliance + price);

    problem.compliance.conservativeResize (known + count);
    problem.compliance.tail (count).setConstant (1 / price);

    if (spread.participation > 0)
        problem.spread = ownSpread (problem, std::sqrt (price) * spread.participation);

    return problem;
}
} // namespace antinode
