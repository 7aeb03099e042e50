#include "LocalPeaks.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
std::vector<std::vector<Eigen::Index>> localPeaks (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& thresholds)
{
    std::vector<std::vector<Eigen::Index>> lists (static_cast<std::size_t> (voltages.cols()));
    const auto last = voltages.rows() - 1;

    for (Eigen::Index i = 0; i < voltages.cols(); ++i)
    {
        const auto* voltage = voltages.col (i).data();

        for (Eigen::Index n = 0; n <= last; ++n)
        {
            const auto value = std::abs (voltage[n]);

            if (value > thresholds[i] && value >= std::abs (voltage[std::max<Eigen::Index> (n - 1, 0)])
                && value >= std::abs (voltage[std::min (n + 1, last)]))
                lists[static_cast<std::size_t> (i)].push_back (n);
        }
    }

    return lists;
}
} // namespace antinode
