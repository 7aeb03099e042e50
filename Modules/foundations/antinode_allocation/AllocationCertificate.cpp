#include "AllocationCertificate.h"

namespace antinode
{
namespace
{
/** What rounding may have added to a bound. */
constexpr auto roundingAllowance = 1e-12;

double price (const WhitenedAllocation& problem, const Eigen::MatrixXd& sampleMultipliers)
{
    return sampleMultipliers.cwiseAbs().colwise().sum().dot (problem.limits);
}
} // namespace

double leastNormBound (const WhitenedAllocation& problem, const RowSystem& rows,
                       const Eigen::MatrixXd& sampleMultipliers, double ratio)
{
    const auto pull = problem.pull (sampleMultipliers);
    const auto y = rows.multipliers (problem.wanted + problem.rowValues (pull));
    const auto shares = (problem.weightedRows (y) - pull).squaredNorm();
    const auto guards = y.cwiseAbs2().dot (problem.compliance);
    return (1 - roundingAllowance)
           * (problem.wanted.dot (y) - 0.5 * (shares + guards) - ratio * price (problem, sampleMultipliers));
}

double minimumPeakBound (const WhitenedAllocation& problem, const Eigen::VectorXd& rowMultipliers,
                         Eigen::MatrixXd sampleMultipliers)
{
    sampleMultipliers += problem.balancing (problem.weightedRows (rowMultipliers) - problem.pull (sampleMultipliers));
    const auto all = price (problem, sampleMultipliers);
    return all > 0 ? (1 - roundingAllowance) * problem.wanted.dot (rowMultipliers) / all : 0;
}
} // namespace antinode
