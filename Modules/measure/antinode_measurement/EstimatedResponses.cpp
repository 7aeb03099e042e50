#include "EstimatedResponses.h"

#include <algorithm>

namespace antinode
{
Eigen::MatrixXd averagedOverNeighbours (const Eigen::MatrixXd& variances)
{
    constexpr Eigen::Index neighbours = 4;
    Eigen::MatrixXd result (variances.rows(), variances.cols());

    for (Eigen::Index line = 0; line < variances.rows(); ++line)
    {
        const auto first = std::max<Eigen::Index> (0, line - neighbours);
        const auto count = std::min (variances.rows(), line + neighbours + 1) - first;
        result.row (line) = variances.middleRows (first, count).colwise().mean();
    }

    return result;
}
} // namespace antinode
