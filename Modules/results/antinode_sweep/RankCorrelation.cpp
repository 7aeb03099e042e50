#include "RankCorrelation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace antinode
{
namespace
{
/** Ranks from 1, equal values sharing the mean of theirs. */
Eigen::VectorXd ranksOf (const Eigen::VectorXd& values)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (values.size()));
    std::iota (order.begin(), order.end(), 0);
    std::sort (order.begin(), order.end(), [&] (auto a, auto b) { return values[a] < values[b]; });
    Eigen::VectorXd ranks (values.size());

    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end)
    {
        while (end < order.size() && values[order[end]] == values[order[begin]])
            ++end;

        for (auto i = begin; i < end; ++i)
            ranks[order[i]] = 0.5 * static_cast<double> (begin + end + 1);
    }

    return ranks;
}
} // namespace

double rankCorrelation (const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    std::vector<Eigen::Index> both;

    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (std::isfinite (a[i]) && std::isfinite (b[i]))
            both.push_back (i);

    if (both.size() < 2)
        return 0;

    Eigen::VectorXd left = ranksOf (a (both)), right = ranksOf (b (both));
    left.array() -= left.mean();
    right.array() -= right.mean();
    const auto scale = left.norm() * right.norm();
    return scale > 0 ? left.dot (right) / scale : 0;
}
} // namespace antinode
