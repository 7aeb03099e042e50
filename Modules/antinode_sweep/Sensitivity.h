#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace antinode
{
/** A number and where 95 % of its bootstrap lie. */
struct EstimatedShare
{
    double value = 0, lower = 0, upper = 0;
};

/** What share of the variance of a result is due to one input: alone, and with all that it does together with others.
 */
struct SobolIndices
{
    EstimatedShare first, total;
};

/** Sobol's indices of a result from the cases of the scheme saltelli: first order by Saltelli et al., total by Jansen.
    @param results  in the order of the cases: of each base case inputs + 2; bases with a NaN are left out
    @param seed     of the bootstrap
    @return         one per input; empty where fewer than 8 bases are left or the result does not vary
    [worker] A. Saltelli et al., Variance based sensitivity analysis of model output, Comput. Phys. Commun. 181, 259
   (2010), table 2 (b) and (f). */
std::vector<SobolIndices> sobolIndices (const Eigen::VectorXd& results, std::size_t inputs, std::uint64_t seed);

/** Spearman's correlation of ranks, of the pairs that have both; 0 where one of them does not vary. [worker] */
double rankCorrelation (const Eigen::VectorXd& a, const Eigen::VectorXd& b);
} // namespace antinode
