#include "WhitenedAllocation.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace antinode
{
namespace
{
RowIndices movedByProduct (const Eigen::MatrixXd& participation, const Eigen::MatrixXd& rows)
{
    constexpr auto nothing = 1e-13;
    RowIndices moved;

    if (participation.size() == 0 || rows.size() == 0)
        return moved;

    const auto participationFloor = nothing * participation.cwiseAbs().maxCoeff();
    const auto rowFloor = nothing * rows.cwiseAbs().maxCoeff();

    for (Eigen::Index k = 0; k < rows.rows(); ++k)
        if (participation.row (k).cwiseAbs().maxCoeff() > participationFloor
            && rows.row (k).cwiseAbs().maxCoeff() > rowFloor)
            moved.push_back (k);

    return moved;
}
} // namespace

RowProducts hardProducts (const AllocationProblem& problem)
{
    return { problem.participation, problem.rows, problem.secondParticipation, problem.secondRows };
}

RowProducts guardProducts (const AllocationProblem& problem)
{
    return { problem.guardParticipation, problem.guardRows, problem.secondGuardParticipation, problem.secondGuardRows };
}

RowProducts chosenRows (const RowProducts& products, const RowIndices& which)
{
    RowProducts chosen { products.participation (which, Eigen::all), products.rows (which, Eigen::all), {}, {} };

    if (products.hasSecond())
    {
        chosen.secondParticipation = products.secondParticipation (which, Eigen::all);
        chosen.secondRows = products.secondRows (which, Eigen::all);
    }

    return chosen;
}

RowIndices movedRows (const RowProducts& products)
{
    auto moved = movedByProduct (products.participation, products.rows);

    if (! products.hasSecond())
        return moved;

    const auto more = movedByProduct (products.secondParticipation, products.secondRows);
    RowIndices both;
    std::set_union (moved.begin(), moved.end(), more.begin(), more.end(), std::back_inserter (both));
    return both;
}

WhitenedAllocation WhitenedAllocation::withoutGuards() const
{
    auto hard = *this;
    hard.responses.conservativeResize (hardRows, Eigen::NoChange);
    hard.participation.conservativeResize (hardRows, Eigen::NoChange);

    if (hard.secondResponses.rows() > 0)
    {
        hard.secondResponses.conservativeResize (hardRows, Eigen::NoChange);
        hard.secondParticipation.conservativeResize (hardRows, Eigen::NoChange);
    }

    hard.wanted.conservativeResize (hardRows);
    hard.compliance.conservativeResize (hardRows);
    return hard;
}

Eigen::VectorXd WhitenedAllocation::rowValues (const Eigen::MatrixXd& shares) const
{
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero (responses.rows(), shares.cols());
    addProduct (values, 1, responses, shares);
    Eigen::VectorXd sums = values.cwiseProduct (participation).rowwise().sum();

    if (secondResponses.rows() > 0)
    {
        values.setZero();
        addProduct (values, 1, secondResponses, shares);
        sums += values.cwiseProduct (secondParticipation).rowwise().sum();
    }

    return sums;
}

Eigen::MatrixXd WhitenedAllocation::rowGram() const
{
    const auto rows = responses.rows();
    const auto overlaps = [rows] (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
    {
        Eigen::MatrixXd product = Eigen::MatrixXd::Zero (rows, rows);
        addTransposedRight (product, 1, a, b);
        return product;
    };
    Eigen::MatrixXd gram = overlaps (responses, responses).cwiseProduct (overlaps (participation, participation));

    if (secondResponses.rows() > 0)
    {
        const Eigen::MatrixXd mixed =
            overlaps (responses, secondResponses).cwiseProduct (overlaps (participation, secondParticipation));
        gram += overlaps (secondResponses, secondResponses)
                    .cwiseProduct (overlaps (secondParticipation, secondParticipation));
        gram += mixed + mixed.transpose();
    }

    return gram;
}

Eigen::MatrixXd WhitenedAllocation::weightedRows (const Eigen::VectorXd& multipliers) const
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero (responses.cols(), participation.cols());
    addTransposedLeft (sums, 1, responses, multipliers.asDiagonal() * participation);

    if (secondResponses.rows() > 0)
        addTransposedLeft (sums, 1, secondResponses, multipliers.asDiagonal() * secondParticipation);

    return sums;
}

Eigen::MatrixXd WhitenedAllocation::responsesTo (Eigen::Index ceramic) const
{
    if (secondResponses.rows() == 0)
        return responses;

    return participation.col (ceramic).asDiagonal() * responses
           + secondParticipation.col (ceramic).asDiagonal() * secondResponses;
}

Eigen::VectorXd WhitenedAllocation::weightsOf (Eigen::Index ceramic) const
{
    if (secondResponses.rows() == 0)
        return participation.col (ceramic);

    return Eigen::VectorXd::Ones (participation.rows());
}

Eigen::VectorXd WhitenedAllocation::direction (Eigen::Index ceramic, Eigen::Index sample) const
{
    const auto weight = sample < voltageSamples ? 1 : slopeWeights[ceramic];
    return weight * basis.row (sample).transpose();
}

Eigen::MatrixXd WhitenedAllocation::voltages (const Eigen::MatrixXd& shares) const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (basis.rows(), shares.cols());
    addProduct (all, 1, basis, shares);

    if (slopeWeights.size() > 0)
        all.bottomRows (basis.rows() - voltageSamples) *= slopeWeights.asDiagonal();

    return all;
}

Eigen::MatrixXd WhitenedAllocation::pull (const Eigen::MatrixXd& sampleMultipliers) const
{
    const auto slopes = basis.rows() - voltageSamples;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero (basis.cols(), sampleMultipliers.cols());
    addTransposedLeft (sums, 1, basis.topRows (voltageSamples), sampleMultipliers.topRows (voltageSamples));

    if (slopes > 0)
        addTransposedLeft (sums, 1, basis.bottomRows (slopes),
                           sampleMultipliers.bottomRows (slopes) * slopeWeights.asDiagonal());

    return sums;
}

Eigen::MatrixXd WhitenedAllocation::balancing (const Eigen::MatrixXd& shares) const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (basis.rows(), shares.cols());
    addProduct (all.topRows (voltageSamples), 1, basis.topRows (voltageSamples), shares);
    return all;
}

double WhitenedAllocation::peakRatio (const Eigen::MatrixXd& shares) const
{
    return voltages (shares).cwiseAbs().colwise().maxCoeff().transpose().cwiseQuotient (limits).maxCoeff();
}

double WhitenedAllocation::objective (const Eigen::MatrixXd& shares) const
{
    const auto guards = wanted.size() - hardRows;
    const Eigen::ArrayXd errors = rowValues (shares).tail (guards);
    return 0.5 * (shares.squaredNorm() + (errors.square() / compliance.tail (guards).array()).sum());
}

Eigen::MatrixXd WhitenedAllocation::completing (const Eigen::VectorXd& missing) const
{
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero (wanted.size());
    multipliers.head (hardRows) = solveFactored (hardFactor, hardScale.cwiseProduct (missing (hardNames)));
    return weightedRows (multipliers);
}

Eigen::MatrixXd WhitenedAllocation::matrix (const Eigen::MatrixXd& shares) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (toShares.rows(), shares.cols());
    addProduct (result, 1, toShares, shares);
    return result.transpose();
}

RowSystem::RowSystem (const WhitenedAllocation& problemToUse) : problem (problemToUse)
{
    factor = problem.rowGram();
    factor.diagonal() += problem.compliance;
    factorLower (factor);
}

Eigen::VectorXd RowSystem::multipliers (const Eigen::VectorXd& values) const
{
    return solveFactored (factor, values);
}

Eigen::MatrixXd RowSystem::halfSolve (Eigen::MatrixXd right) const
{
    solveLower (factor, right);
    return right;
}

Eigen::MatrixXd RowSystem::leastNormShares() const
{
    return withExactRows (problem.weightedRows (multipliers (problem.wanted)));
}

Eigen::MatrixXd RowSystem::withExactRows (Eigen::MatrixXd shares) const
{
    constexpr auto refinements = 2;

    for (int i = 0; i < refinements; ++i)
    {
        Eigen::VectorXd change = Eigen::VectorXd::Zero (problem.wanted.size());
        change.head (problem.hardRows) =
            solveFactored (problem.hardFactor, (problem.wanted - problem.rowValues (shares)).head (problem.hardRows));
        shares += problem.weightedRows (change);
    }

    return shares;
}

namespace
{
using Rows = RowIndices;

/** Whether columns with this triangle are. */
bool areIndependent (const Eigen::MatrixXd& triangle)
{
    constexpr auto dependence = 1e-5;
    return triangle.diagonal().cwiseAbs().minCoeff() > dependence;
}

/** Between two looks at the watch, which memory makes long. */
constexpr Eigen::Index samplesAtOnce = 1024;

/** The norm of each drive; 1 of one that is 0. */
Eigen::VectorXd rowLengths (const Eigen::MatrixXd& waveforms)
{
    Eigen::VectorXd squares = Eigen::VectorXd::Zero (waveforms.rows());

    for (Eigen::Index first = 0; first < waveforms.cols(); first += samplesAtOnce)
    {
        checkWatch();
        const auto count = std::min (samplesAtOnce, waveforms.cols() - first);
        squares += waveforms.middleCols (first, count).cwiseAbs2().rowwise().sum();
    }

    return (squares.array() > 0).select (squares.cwiseSqrt(), 1.0);
}

/** Each drive by its length, one a column. */
Eigen::MatrixXd unitColumns (const Eigen::MatrixXd& waveforms, const Eigen::VectorXd& lengths)
{
    Eigen::MatrixXd columns (waveforms.cols(), waveforms.rows());

    for (Eigen::Index first = 0; first < waveforms.cols(); first += samplesAtOnce)
    {
        checkWatch();
        const auto count = std::min (samplesAtOnce, waveforms.cols() - first);
        columns.middleRows (first, count) =
            (lengths.cwiseInverse().asDiagonal() * waveforms.middleCols (first, count)).transpose();
    }

    return columns;
}

/** Basis and shares of the drives, orthonormalised twice. Where a drive depends on others each gets a tiny sample of
   its own, so that no matrix lives from the cancellation of huge shares. */
void whitenDrives (WhitenedAllocation& whitened, const Eigen::MatrixXd& waveforms)
{
    constexpr auto ownSample = 1e-4;
    const auto drives = waveforms.rows();
    const auto lengths = rowLengths (waveforms);
    auto columns = unitColumns (waveforms, lengths);
    auto triangle = orthogonalTriangle (columns);

    if (! areIndependent (triangle))
    {
        columns.conservativeResize (columns.rows() + drives, Eigen::NoChange);
        columns.bottomRows (drives) = Eigen::MatrixXd::Identity (drives, drives) * ownSample;
        triangle = orthogonalTriangle (columns);
    }

    whitened.basis = std::move (columns);
    whitened.voltageSamples = whitened.basis.rows();
    const Eigen::MatrixXd lower = triangle.transpose();
    solveLowerTransposedFromRight (lower, whitened.basis);
    Eigen::MatrixXd rounding = Eigen::MatrixXd::Zero (drives, drives);
    addTransposedLeft (rounding, 1, whitened.basis, whitened.basis);
    factorLower (rounding);
    solveLowerTransposedFromRight (rounding, whitened.basis);
    // From the left: the errors are then those of columns of inverses, which the waveforms do not magnify.
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity (drives, drives), inverseRounding = inverse;
    solveLowerTransposed (lower, inverse);
    solveLowerTransposed (rounding, inverseRounding);
    whitened.toShares = Eigen::MatrixXd::Zero (drives, drives);
    addProduct (whitened.toShares, whitened.voltageUnit, inverse, inverseRounding);
    whitened.toShares = lengths.cwiseInverse().asDiagonal() * whitened.toShares;
}

/** Puts the slopes below the voltages' samples. */
void appendSlopes (WhitenedAllocation& whitened, const AllocationProblem& problem)
{
    if (problem.slopes.size() == 0)
        return;

    const auto first = whitened.voltageSamples + 1;
    whitened.slopeWeights = problem.voltageLimits.cwiseQuotient (problem.slewLimits);
    whitened.basis.conservativeResize (first + problem.slopes.cols(), Eigen::NoChange);
    whitened.basis.row (first - 1).setZero();
    auto slopes = whitened.basis.bottomRows (problem.slopes.cols());
    slopes.setZero();
    addTransposedLeft (slopes, 1 / whitened.voltageUnit, problem.slopes, whitened.toShares);
}

Rows movedHardRows (const AllocationProblem& problem)
{
    auto moved = movedRows (hardProducts (problem));

    for (Eigen::Index k = 0; k < problem.wanted.size(); ++k)
        if (problem.wanted[k] != 0 && ! std::binary_search (moved.begin(), moved.end(), k))
            throw InputError ("allocation",
                              "no ceramic excites controlled mode row " + std::to_string (k + 1)
                                  + " (counted from 1); leave this mode out, or place a ceramic where it bends");

    return moved;
}

void appendBelow (Eigen::MatrixXd& matrix, const Eigen::MatrixXd& more)
{
    matrix.conservativeResize (matrix.rows() + more.rows(), more.cols());
    matrix.bottomRows (more.rows()) = more;
}

/** Puts rows below those that are there, each scaled to a Gram entry of 1.
    @return  the factors by which they were scaled */
Eigen::VectorXd appendRows (WhitenedAllocation& whitened, const RowProducts& products)
{
    const auto seen = [&] (const Eigen::MatrixXd& rows)
    {
        Eigen::MatrixXd responses = Eigen::MatrixXd::Zero (rows.rows(), rows.cols());
        addProduct (responses, 1, rows, whitened.toShares);
        return responses;
    };
    const auto responses = seen (products.rows);
    const auto& participation = products.participation;
    Eigen::VectorXd scale = responses.rowwise().norm().cwiseProduct (participation.rowwise().norm()).cwiseInverse();

    if (products.hasSecond())
    {
        const auto second = seen (products.secondRows);
        const auto& other = products.secondParticipation;
        const auto squares = responses.rowwise().squaredNorm().cwiseProduct (participation.rowwise().squaredNorm())
                             + second.rowwise().squaredNorm().cwiseProduct (other.rowwise().squaredNorm())
                             + 2
                                   * responses.cwiseProduct (second).rowwise().sum().cwiseProduct (
                                       participation.cwiseProduct (other).rowwise().sum());
        scale = squares.cwiseSqrt().cwiseInverse();
        appendBelow (whitened.secondResponses, scale.asDiagonal() * second);
        appendBelow (whitened.secondParticipation, other);
    }

    appendBelow (whitened.responses, scale.asDiagonal() * responses);
    appendBelow (whitened.participation, participation);
    return scale;
}

/** Refuses rows that contradict or repeat those before them: the pivots of their Gram matrix are squared distances from
   the span of those. The shift keeps the factoring from breaking down at the first such row. */
void checkIndependentRows (Eigen::MatrixXd gram, const Rows& names)
{
    constexpr auto smallestDistance = 1e-6;
    constexpr auto shift = 1e-13;
    gram.diagonal().array() += shift;
    factorLower (gram);

    for (Eigen::Index k = 0; k < gram.rows(); ++k)
        if (! (gram (k, k) > smallestDistance))
            throw InputError (
                "allocation",
                "controlled mode row " + std::to_string (names[static_cast<std::size_t> (k)] + 1)
                    + " (counted from 1) cannot be controlled independently of the rows before it: too few "
                      "ceramics or drives; leave a mode out, or place another ceramic");
}

/** Guards beyond a stiffness are as good as hard; the floor keeps the system solvable. */
void appendGuards (WhitenedAllocation& whitened, const AllocationProblem& problem)
{
    constexpr auto minimumCompliance = 1e-12;
    const auto guards = guardProducts (problem);
    const auto moved = movedRows (guards);

    if (moved.empty() || problem.guardWeight == 0)
        return;

    const auto minimumEnergy = whitened.wanted.dot (solveFactored (whitened.hardFactor, whitened.wanted).col (0));
    const auto stiffness = problem.guardWeight * minimumEnergy / problem.wanted.squaredNorm();
    const auto scale = appendRows (whitened, chosenRows (guards, moved));
    const auto count = static_cast<Eigen::Index> (moved.size());
    whitened.wanted.conservativeResize (whitened.hardRows + count);
    whitened.wanted.tail (count).setZero();
    whitened.compliance.conservativeResize (whitened.hardRows + count);
    whitened.compliance.tail (count) = (scale.array().square() / stiffness).max (minimumCompliance);
}
} // namespace

WhitenedAllocation whiten (const AllocationProblem& problem)
{
    const auto hard = movedHardRows (problem);
    WhitenedAllocation whitened;
    whitened.voltageUnit = problem.voltageLimits.maxCoeff();
    whitened.limits = problem.voltageLimits / whitened.voltageUnit;
    whitenDrives (whitened, problem.waveforms);
    appendSlopes (whitened, problem);
    const auto scale = appendRows (whitened, chosenRows (hardProducts (problem), hard));
    whitened.hardRows = scale.size();
    whitened.hardNames = hard;
    whitened.hardScale = scale;
    whitened.wanted = scale.cwiseProduct (problem.wanted (hard));
    whitened.compliance = Eigen::VectorXd::Zero (scale.size());
    whitened.hardFactor = whitened.rowGram();
    checkIndependentRows (whitened.hardFactor, hard);
    factorLower (whitened.hardFactor);
    appendGuards (whitened, problem);
    return whitened;
}
} // namespace antinode
