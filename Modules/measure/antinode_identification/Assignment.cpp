#include "Assignment.h"

#include <limits>

namespace antinode
{
namespace
{
/** Rows assigned one after the other, each by a shortest augmenting path; columns count from 1, 0 stands for none. */
class ShortestPaths
{
public:
    explicit ShortestPaths (const Eigen::MatrixXd& costsToUse)
        : costs (costsToUse), rowPrice (Eigen::VectorXd::Zero (costs.rows() + 1)),
          columnPrice (Eigen::VectorXd::Zero (costs.cols() + 1)), assignedRows (columnCount(), 0)
    {
    }

    void add (Eigen::Index row)
    {
        std::vector<Eigen::Index> before (columnCount(), 0);
        std::vector<bool> seen (columnCount(), false);
        std::vector<double> minimumCost (columnCount(), std::numeric_limits<double>::infinity());
        assignedRows[0] = row + 1;
        std::size_t column = 0;

        do
        {
            seen[column] = true;
            column = advance (column, before, seen, minimumCost);
        } while (assignedRows[column] != 0);

        for (; column != 0; column = static_cast<std::size_t> (before[column]))
            assignedRows[column] = assignedRows[static_cast<std::size_t> (before[column])];
    }

    Eigen::Index assignedRow (Eigen::Index column) const
    {
        return assignedRows[static_cast<std::size_t> (column + 1)] - 1;
    }

private:
    std::size_t columnCount() const { return static_cast<std::size_t> (costs.cols() + 1); }

    /** One step of Dijkstra's method over reduced costs. @return the next column */
    std::size_t advance (std::size_t column, std::vector<Eigen::Index>& before, const std::vector<bool>& seen,
                         std::vector<double>& minimumCost)
    {
        const auto row = assignedRows[column];
        auto delta = std::numeric_limits<double>::infinity();
        std::size_t next = 0;

        for (std::size_t j = 1; j < columnCount(); ++j)
        {
            if (seen[j])
                continue;

            const auto index = static_cast<Eigen::Index> (j);

            if (const auto cost = costs (row - 1, index - 1) - rowPrice[row] - columnPrice[index];
                cost < minimumCost[j])
            {
                minimumCost[j] = cost;
                before[j] = static_cast<Eigen::Index> (column);
            }

            if (minimumCost[j] < delta)
            {
                delta = minimumCost[j];
                next = j;
            }
        }

        for (std::size_t j = 0; j < columnCount(); ++j)
        {
            if (seen[j])
            {
                rowPrice[assignedRows[j]] += delta;
                columnPrice[static_cast<Eigen::Index> (j)] -= delta;
            }
            else
            {
                minimumCost[j] -= delta;
            }
        }

        return next;
    }

    const Eigen::MatrixXd& costs;
    Eigen::VectorXd rowPrice, columnPrice;
    std::vector<Eigen::Index> assignedRows;
};
} // namespace

std::vector<Eigen::Index> assign (const Eigen::MatrixXd& scores)
{
    const auto isWide = scores.rows() <= scores.cols();
    const Eigen::MatrixXd costs = isWide ? Eigen::MatrixXd (-scores) : Eigen::MatrixXd (-scores.transpose());
    ShortestPaths paths (costs);
    std::vector<Eigen::Index> result (static_cast<std::size_t> (scores.rows()), -1);

    for (Eigen::Index row = 0; row < costs.rows(); ++row)
        paths.add (row);

    for (Eigen::Index column = 0; column < costs.cols(); ++column)
        if (const auto row = paths.assignedRow (column); row >= 0)
            result[static_cast<std::size_t> (isWide ? row : column)] = isWide ? column : row;

    return result;
}
} // namespace antinode
