#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The one-to-one assignment of rows to columns with the largest sum of scores, by the Hungarian method.
    @param scores  N x M, finite
    @return        for each row its column, -1 where there are fewer columns than rows and it has none
    [worker] Kuhn, Naval Research Logistics Quarterly 2 (1955) 83. */
std::vector<Eigen::Index> assign (const Eigen::MatrixXd& scores);
} // namespace antinode
