#include "AllocationInteriorPoint.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
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

namespace
{
/** Exponent with which the next barrier follows what the predictor reaches; 3 is Mehrotra's, less is steadier when
    samples join. */
constexpr auto centring = 1.5;

constexpr auto fractionToBoundary = 0.999;
constexpr auto shortestStep = 1e-10;
} // namespace

AllocationInteriorPoint::AllocationInteriorPoint (const WhitenedAllocation& problemToUse, Ratio kindToUse,
                                                  double ratioToUse, double curvatureToUse, Eigen::MatrixXd shares)
    : problem (problemToUse), kind (kindToUse), ratio (ratioToUse), curvature (curvatureToUse), x (std::move (shares)),
      y (Eigen::VectorXd::Zero (problemToUse.wanted.size()))
{
    ceramics.reserve (static_cast<std::size_t> (problem.ceramics()));

    for (Eigen::Index i = 0; i < problem.ceramics(); ++i)
        ceramics.emplace_back (problem.limits[i], problem.drives());
}

void AllocationInteriorPoint::addSamples (const std::vector<SampleList>& lists)
{
    const auto product = products() > 0 ? complementarity() / products() : firstProduct (lists);

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        checkWatch();
        const auto ceramic = static_cast<Eigen::Index> (i);
        const auto fresh = ceramics[i].notYetLimited (lists[i]);
        Eigen::MatrixXd directions (problem.drives(), fresh.size());

        for (Eigen::Index j = 0; j < directions.cols(); ++j)
            directions.col (j) = problem.direction (ceramic, fresh[static_cast<std::size_t> (j)]);

        ceramics[i].add (fresh, directions, x.col (ceramic), ratio, product);
    }
}

double AllocationInteriorPoint::firstProduct (const std::vector<SampleList>& lists) const
{
    const auto value = kind == Ratio::free ? ratio : curvature * problem.objective (x);
    std::size_t count = 0;

    for (const auto& list : lists)
        count += 2 * list.size();

    return value / static_cast<double> (std::max<std::size_t> (count, 1));
}

bool AllocationInteriorPoint::step()
{
    if (! factor())
        return false;

    auto targets = residuals();
    const auto predictor = solve (targets);
    const auto reached = complementarity (predictor, longestStep (predictor)) / complementarity();
    const auto product = complementarity() / products() * std::pow (reached, centring);

    for (std::size_t i = 0; i < ceramics.size(); ++i)
        targets[i].complementarity += product - predictor.ceramics[i].slack * predictor.ceramics[i].multiplier;

    const auto direction = solve (targets);
    const auto length = std::min (1.0, fractionToBoundary * longestStep (direction));

    if (! (length > shortestStep))
        return false;

    advance (direction, length);
    return true;
}

bool AllocationInteriorPoint::factor()
{
    Eigen::MatrixXd matrix = (problem.compliance / curvature).asDiagonal();
    ratioOnRows = Eigen::VectorXd::Zero (problem.wanted.size());
    ratioStiffness = 0;
    auto areFactored = true;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        checkWatch();
        auto& ceramic = ceramics[i];
        ceramic.factor (curvature, problem.responsesTo (static_cast<Eigen::Index> (i)));
        const auto participation = problem.weightsOf (static_cast<Eigen::Index> (i));
        const Eigen::MatrixXd rows = participation.asDiagonal() * ceramic.halfRows().transpose();
        addGram (matrix, 1, rows);
        ratioOnRows += rows * ceramic.halfRatio();
        ratioStiffness += ceramic.ratioStiffness() - ceramic.halfRatio().squaredNorm();
        areFactored = areFactored && ceramic.isFactored();
    }

    rowSystem = std::move (matrix);

    if (! areFactored || ! factorLower (rowSystem))
        return false;

    ratioMultipliers = rowSolve (ratioOnRows);
    ratioStiffness += ratioOnRows.dot (ratioMultipliers);
    return true;
}

Eigen::VectorXd AllocationInteriorPoint::rowSolve (Eigen::VectorXd right) const
{
    solveLower (rowSystem, right);
    solveLowerTransposed (rowSystem, right);
    return right;
}

AllocationInteriorPoint::Residuals AllocationInteriorPoint::residuals() const
{
    const auto pull = kind == Ratio::fixed ? curvature : 0.0;
    const Eigen::MatrixXd stationarity = pull * x - problem.weightedRows (y);
    Residuals all (ceramics.size());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        checkWatch();
        const auto& ceramic = ceramics[i];
        const auto column = static_cast<Eigen::Index> (i);
        all[i].share = stationarity.col (column) + ceramic.netPull();
        all[i].slack = ceramic.slackResidual (x.col (column), ratio);
        all[i].complementarity = -ceramic.slack() * ceramic.multiplier();
    }

    return all;
}

AllocationInteriorPoint::Direction AllocationInteriorPoint::solve (const Residuals& residuals) const
{
    Eigen::MatrixXd halves (problem.drives(), problem.ceramics());
    Eigen::VectorXd rows = problem.wanted - problem.rowValues (x) - problem.compliance.cwiseProduct (y) / curvature;
    double ratioResidual = -1;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        checkWatch();
        const auto column = static_cast<Eigen::Index> (i);
        halves.col (column) = ceramics[i].halfSolve (ceramics[i].pull (residuals[i]));
        rows -= problem.weightsOf (column).cwiseProduct (ceramics[i].halfRows().transpose() * halves.col (column));
        ratioResidual += ceramics[i].price() + ceramics[i].ratioPull (residuals[i])
                         + ceramics[i].halfRatio().dot (halves.col (column));
    }

    Direction direction;
    direction.rows = rowSolve (rows);

    if (kind == Ratio::free)
    {
        direction.ratio = (ratioResidual + ratioOnRows.dot (direction.rows)) / ratioStiffness;
        direction.rows -= ratioMultipliers * direction.ratio;
    }

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        checkWatch();
        const auto& ceramic = ceramics[i];
        const auto column = static_cast<Eigen::Index> (i);
        const Eigen::VectorXd half = halves.col (column) + ceramic.halfRatio() * direction.ratio
                                     + ceramic.halfRows() * direction.rows.cwiseProduct (problem.weightsOf (column));
        direction.ceramics.push_back (ceramic.direction (residuals[i], ceramic.otherHalfSolve (half), direction.ratio));
    }

    return direction;
}

void AllocationInteriorPoint::advance (const Direction& direction, double length)
{
    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        ceramics[i].advance (direction.ceramics[i], length);
        x.col (static_cast<Eigen::Index> (i)) += length * direction.ceramics[i].share;
    }

    y += length * direction.rows;
    ratio += length * direction.ratio;
}

double AllocationInteriorPoint::complementarity() const
{
    double sum = 0;

    for (const auto& ceramic : ceramics)
        sum += ceramic.complementarity();

    return sum;
}

double AllocationInteriorPoint::complementarity (const Direction& direction, double length) const
{
    double sum = 0;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
        sum += ceramics[i].complementarity (direction.ceramics[i], length);

    return sum;
}

double AllocationInteriorPoint::longestStep (const Direction& direction) const
{
    double length = 1;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
        length = std::min (length, ceramics[i].longestStep (direction.ceramics[i]));

    return length;
}

double AllocationInteriorPoint::products() const
{
    double count = 0;

    for (const auto& ceramic : ceramics)
        count += static_cast<double> (ceramic.slack().size());

    return count;
}

std::vector<SampleList> AllocationInteriorPoint::samples() const
{
    std::vector<SampleList> lists;

    for (const auto& ceramic : ceramics)
        lists.push_back (ceramic.samples());

    return lists;
}

Eigen::MatrixXd AllocationInteriorPoint::sampleMultipliers() const
{
    Eigen::MatrixXd multipliers = Eigen::MatrixXd::Zero (problem.basis.rows(), problem.ceramics());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
        multipliers (ceramics[i].samples(), static_cast<Eigen::Index> (i)) = ceramics[i].netMultiplier();

    return multipliers;
}
} // namespace antinode
