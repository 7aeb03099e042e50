#include "BlockBandedMatrix.h"

#include "DenseKernels.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <utility>

namespace antinode
{
BlockBandedMatrix::BlockBandedMatrix (const std::vector<Eigen::Index>& sizes, std::vector<Eigen::Index> reach)
    : begins { 0 }, last (std::move (reach))
{
    for (std::size_t block = 0; block < sizes.size(); ++block)
    {
        begins.push_back (begins.back() + sizes[block]);
        blockOfUnknown.insert (blockOfUnknown.end(), static_cast<std::size_t> (sizes[block]),
                               static_cast<Eigen::Index> (block));
    }

    for (std::size_t block = 0; block < sizes.size(); ++block)
    {
        checkWatch(); // Memory that is touched for the first time takes long.
        panels.emplace_back (
            Eigen::MatrixXd::Zero (begins[static_cast<std::size_t> (last[block]) + 1] - begins[block], sizes[block]));
    }
}

void BlockBandedMatrix::add (Eigen::Index row, Eigen::Index column, double value)
{
    const auto [low, high] = std::minmax (row, column);
    const auto block = blockOf (low);
    panel (block) (high - begin (block), low - begin (block)) += value;
}

Eigen::MatrixXd BlockBandedMatrix::operator* (const Eigen::MatrixXd& columns) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (columns.rows(), columns.cols());

    for (Eigen::Index block = 0; block < blocks(); ++block)
    {
        checkWatch();
        const auto& own = panel (block);
        const auto first = begin (block), count = size (block), below = own.rows() - count;

        if (count == 0)
            continue;

        const Eigen::MatrixXd diagonal = own.topRows (count).selfadjointView<Eigen::Lower>();
        addProduct (result.middleRows (first, count), 1, diagonal, columns.middleRows (first, count));
        addProduct (result.middleRows (first + count, below), 1, own.bottomRows (below),
                    columns.middleRows (first, count));
        addTransposedLeft (result.middleRows (first, count), 1, own.bottomRows (below),
                           columns.middleRows (first + count, below));
    }

    return result;
}

void BlockBandedMatrix::addMultiple (double factor, const BlockBandedMatrix& other)
{
    for (Eigen::Index block = 0; block < blocks(); ++block)
        panel (block) += factor * other.panel (block);
}

Eigen::VectorXd BlockBandedMatrix::diagonal() const
{
    Eigen::VectorXd result (size());

    for (Eigen::Index block = 0; block < blocks(); ++block)
        result.segment (begin (block), size (block)) = panel (block).diagonal();

    return result;
}
} // namespace antinode
