#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Spearman's correlation of ranks, of the pairs that have both; 0 where one of them does not vary. [worker] */
double rankCorrelation (const Eigen::VectorXd& a, const Eigen::VectorXd& b);
} // namespace antinode
