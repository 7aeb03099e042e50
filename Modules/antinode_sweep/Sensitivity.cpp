#include "Sensitivity.h"

#include "Philox.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
/** A row for each base case: first matrix, second, then the first with each column of the second; less their mean. */
Eigen::MatrixXd wholeBases (const Eigen::VectorXd& results, std::size_t inputs)
{
    const auto columns = static_cast<Eigen::Index> (inputs + 2);
    const auto rows = results.size() / columns;
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> all (results.data(),
                                                                                                        rows, columns);
    std::vector<Eigen::Index> whole;

    for (Eigen::Index i = 0; i < rows; ++i)
        if (all.row (i).allFinite())
            whole.push_back (i);

    Eigen::MatrixXd bases = all (whole, Eigen::all);

    if (bases.rows() > 0)
        bases.array() -= bases.leftCols (2).mean();

    return bases;
}

/** First order and total of every input, of chosen rows: 2 x inputs. */
Eigen::Matrix2Xd indicesOf (const Eigen::MatrixXd& bases, const std::vector<Eigen::Index>& rows)
{
    const auto inputs = bases.cols() - 2;
    Eigen::Matrix2Xd sums = Eigen::Matrix2Xd::Zero (2, inputs);
    double sum = 0, squares = 0;

    for (const auto row : rows)
    {
        const auto a = bases (row, 0), b = bases (row, 1);
        sum += a + b;
        squares += a * a + b * b;

        for (Eigen::Index i = 0; i < inputs; ++i)
        {
            const auto mixed = bases (row, i + 2);
            sums (0, i) += b * (mixed - a);
            sums (1, i) += 0.5 * (a - mixed) * (a - mixed);
        }
    }

    const auto count = static_cast<double> (rows.size());
    const auto mean = sum / (2 * count);
    const auto variance = squares / (2 * count) - mean * mean;
    return variance > 0 ? Eigen::Matrix2Xd (sums / (count * variance)) : Eigen::Matrix2Xd::Zero (2, inputs);
}

EstimatedShare withInterval (double value, std::vector<double> resampled)
{
    constexpr double tail = 0.025;
    std::sort (resampled.begin(), resampled.end());
    const auto at = [&] (double share)
    { return resampled[static_cast<std::size_t> (share * static_cast<double> (resampled.size() - 1))]; };
    return { value, at (tail), at (1 - tail) };
}

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

std::vector<SobolIndices> sobolIndices (const Eigen::VectorXd& results, std::size_t inputs, std::uint64_t seed)
{
    constexpr Eigen::Index fewest = 8;
    constexpr std::uint32_t resamplings = 500;
    const auto bases = wholeBases (results, inputs);

    if (bases.rows() < fewest || (bases.array() == bases (0, 0)).all())
        return {};

    std::vector<Eigen::Index> rows (static_cast<std::size_t> (bases.rows()));
    std::iota (rows.begin(), rows.end(), 0);
    const auto best = indicesOf (bases, rows);
    std::vector<std::vector<double>> firsts (inputs), totals (inputs);

    for (std::uint32_t n = 0; n < resamplings; ++n)
    {
        checkWatch();

        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i] = static_cast<Eigen::Index> (randomUniform (seed, i, n) * static_cast<double> (bases.rows()));

        const auto again = indicesOf (bases, rows);

        for (std::size_t i = 0; i < inputs; ++i)
        {
            firsts[i].push_back (again (0, static_cast<Eigen::Index> (i)));
            totals[i].push_back (again (1, static_cast<Eigen::Index> (i)));
        }
    }

    std::vector<SobolIndices> indices;

    for (std::size_t i = 0; i < inputs; ++i)
        indices.push_back ({ withInterval (best (0, static_cast<Eigen::Index> (i)), std::move (firsts[i])),
                             withInterval (best (1, static_cast<Eigen::Index> (i)), std::move (totals[i])) });

    return indices;
}

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
