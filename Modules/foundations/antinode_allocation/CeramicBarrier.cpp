#include "CeramicBarrier.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
/** Column 0 as it is, column 1 negated. */
Eigen::ArrayX2d bothSigns (const Eigen::VectorXd& values)
{
    Eigen::ArrayX2d signedValues (values.size(), 2);
    signedValues.col (0) = values;
    signedValues.col (1) = -values;
    return signedValues;
}

double longestStep (const Eigen::ArrayX2d& values, const Eigen::ArrayX2d& changes)
{
    double step = 1;

    for (Eigen::Index i = 0; i < values.size(); ++i)
        if (changes.data()[i] < 0)
            step = std::min (step, -values.data()[i] / changes.data()[i]);

    return step;
}

/** How the multipliers change at fixed share and ratio. */
Eigen::ArrayX2d multiplierPull (const CeramicBarrier::Residual& residual, const Eigen::ArrayX2d& slack,
                                const Eigen::ArrayX2d& multiplier)
{
    return (residual.complementarity - multiplier * residual.slack) / slack;
}
} // namespace

CeramicBarrier::CeramicBarrier (double limitToUse, Eigen::Index drives) : limit (limitToUse), directions (drives, 0) {}

SampleList CeramicBarrier::notYetLimited (const SampleList& samples) const
{
    SampleList fresh;

    for (const auto sample : samples)
        if (std::find (workingSet.begin(), workingSet.end(), sample) == workingSet.end())
            fresh.push_back (sample);

    return fresh;
}

void CeramicBarrier::add (const SampleList& fresh, const Eigen::MatrixXd& freshDirections, const Eigen::VectorXd& share,
                          double ratio, double barrier)
{
    constexpr auto minimumSlack = 0.02; // Of the limit: smaller ones would tie the next steps to a barely kept limit.
    const auto count = freshDirections.cols();
    const Eigen::ArrayX2d freshSlacks =
        (ratio * limit - bothSigns (freshDirections.transpose() * share)).max (minimumSlack * ratio * limit);
    workingSet.insert (workingSet.end(), fresh.begin(), fresh.end());
    const auto total = static_cast<Eigen::Index> (workingSet.size());
    directions.conservativeResize (Eigen::NoChange, total);
    directions.rightCols (count) = freshDirections;
    slacks.conservativeResize (total, Eigen::NoChange);
    slacks.bottomRows (count) = freshSlacks;
    multipliers.conservativeResize (total, Eigen::NoChange);
    multipliers.bottomRows (count) = barrier / freshSlacks;
}

void CeramicBarrier::factor (double curvature, const Eigen::MatrixXd& responses)
{
    const Eigen::ArrayX2d weights = multipliers / slacks;
    const Eigen::VectorXd both = weights.rowwise().sum();
    const auto drives = directions.rows();
    const Eigen::MatrixXd scaled = directions * both.cwiseSqrt().asDiagonal();
    lower = Eigen::MatrixXd::Identity (drives, drives) * curvature;
    addGram (lower, 1, scaled);
    factored = factorLower (lower);
    rowsOverL = responses.transpose();
    solveLower (lower, rowsOverL);
    const Eigen::VectorXd net = (weights.col (0) - weights.col (1)).matrix();
    ratioOverL = halfSolve (limit * (directions * net));
    stiffness = limit * limit * both.sum();
}

Eigen::VectorXd CeramicBarrier::halfSolve (Eigen::VectorXd right) const
{
    solveLower (lower, right);
    return right;
}

Eigen::VectorXd CeramicBarrier::otherHalfSolve (Eigen::VectorXd right) const
{
    solveLowerTransposed (lower, right);
    return right;
}

Eigen::VectorXd CeramicBarrier::pull (const Residual& residual) const
{
    const auto change = multiplierPull (residual, slacks, multipliers);
    return -residual.share - directions * (change.col (0) - change.col (1)).matrix();
}

double CeramicBarrier::ratioPull (const Residual& residual) const
{
    return limit * multiplierPull (residual, slacks, multipliers).sum();
}

CeramicBarrier::Direction CeramicBarrier::direction (const Residual& residual, Eigen::VectorXd share,
                                                     double ratio) const
{
    Direction change;
    change.slack = residual.slack + limit * ratio - bothSigns (directions.transpose() * share);
    change.multiplier = (residual.complementarity - multipliers * change.slack) / slacks;
    change.share = std::move (share);
    return change;
}

double CeramicBarrier::longestStep (const Direction& change) const
{
    return std::min (antinode::longestStep (slacks, change.slack),
                     antinode::longestStep (multipliers, change.multiplier));
}

void CeramicBarrier::advance (const Direction& change, double step)
{
    slacks += step * change.slack;
    multipliers += step * change.multiplier;
}

Eigen::ArrayX2d CeramicBarrier::slackResidual (const Eigen::VectorXd& share, double ratio) const
{
    return ratio * limit - bothSigns (directions.transpose() * share) - slacks;
}

double CeramicBarrier::complementarity (const Direction& change, double step) const
{
    return ((slacks + step * change.slack) * (multipliers + step * change.multiplier)).sum();
}
} // namespace antinode
