#include "TolerantSamples.h"

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
