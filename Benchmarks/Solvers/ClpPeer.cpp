#include "ClpPeer.h"

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include <ctime>
#include <limits>
#include <vector>

namespace antinode::bench
{
namespace
{
/** The entries of a sparse matrix, as they come. */
struct Entries
{
    std::vector<int> rows, columns;
    std::vector<double> values;

    void put (int row, int column, double value)
    {
        rows.push_back (row);
        columns.push_back (column);
        values.push_back (value);
    }
};

/** Rows first, then for each sample q x - p limit <= 0 and q x + p limit >= 0. */
Entries makeEntries (const PeerProblem& problem)
{
    Entries entries;
    const auto& basis = problem.whitened.basis;
    const auto drives = static_cast<int> (basis.cols());
    const auto ratio = problem.unknowns();
    auto row = 0;

    for (; row < problem.rows.rows(); ++row)
        for (int c = 0; c < problem.unknowns(); ++c)
            entries.put (row, c, problem.rows (row, c));

    for (int i = 0; i < problem.whitened.ceramics(); ++i)
        for (int s = 0; s < problem.samples(); ++s)
            for (const auto sign : { -1, 1 })
            {
                for (int l = 0; l < drives; ++l)
                    entries.put (row, i * drives + l, basis (s, l));

                entries.put (row++, ratio, sign * problem.whitened.limits[i]);
            }

    return entries;
}

/** The bounds of the constraints: equal for the rows, one-sided for the samples. */
std::pair<std::vector<double>, std::vector<double>> makeBounds (const PeerProblem& problem)
{
    constexpr auto unlimited = std::numeric_limits<double>::max();
    const auto& wanted = problem.whitened.wanted;
    std::vector<double> low (wanted.data(), wanted.data() + wanted.size()), high = low;

    for (int n = 0; n < problem.samples() * static_cast<int> (problem.whitened.ceramics()); ++n)
    {
        low.insert (low.end(), { -unlimited, 0 });
        high.insert (high.end(), { 0, unlimited });
    }

    return { low, high };
}
} // namespace

PeerResult minimumPeakByClp (const PeerProblem& problem, double tolerance)
{
    PeerResult result;
    const auto begin = std::clock();
    const auto columns = problem.unknowns() + 1;
    const auto entries = makeEntries (problem);
    const auto [low, high] = makeBounds (problem);
    const CoinPackedMatrix matrix (false, entries.rows.data(), entries.columns.data(), entries.values.data(),
                                   static_cast<CoinBigIndex> (entries.values.size()));
    std::vector<double> columnLow (static_cast<std::size_t> (columns), -std::numeric_limits<double>::max());
    std::vector<double> cost (static_cast<std::size_t> (columns), 0);
    columnLow.back() = 0;
    cost.back() = 1;
    ClpSimplex model;
    model.setLogLevel (0);
    model.loadProblem (matrix, columnLow.data(), nullptr, cost.data(), low.data(), high.data());
    model.setPrimalTolerance (tolerance);
    model.setDualTolerance (tolerance);
    model.dual();
    result.hasEnded = model.isProvenOptimal();
    result.x = Eigen::Map<const Eigen::VectorXd> (model.primalColumnSolution(), columns);
    result.seconds = static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
    return result;
}
} // namespace antinode::bench
