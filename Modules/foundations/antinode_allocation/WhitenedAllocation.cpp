#include "WhitenedAllocation.h"

#include <antinode_numerics/DenseKernels.h>

namespace antinode
{
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
} // namespace antinode
