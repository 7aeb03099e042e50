#include "BlockBandedMatrix.h"

#include "DenseKernels.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
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

BlockBandedFactor::BlockBandedFactor (BlockBandedMatrix matrix) : lower (std::move (matrix)), pivots (lower.size())
{
    for (Eigen::Index block = 0; block < lower.blocks() && usable; ++block)
        eliminate (block);

    negatives = usable ? (pivots.array() < 0).count() : 0;
}

void BlockBandedFactor::eliminate (Eigen::Index block)
{
    auto& panel = lower.panel (block);
    const auto size = lower.size (block), begin = lower.begin (block);
    Eigen::MatrixXd scaled;

    for (auto before = block - 1; before >= 0 && lower.reach (before) >= block; --before)
    {
        const auto& left = lower.panel (before);
        const auto offset = begin - lower.begin (before);
        const auto rows = left.rows() - offset;
        scaled =
            left.middleRows (offset, size) * pivots.segment (lower.begin (before), lower.size (before)).asDiagonal();
        addTransposedRight (panel.topRows (rows), -1, left.bottomRows (rows), scaled);
    }

    factorDiagonal (block);
    auto below = panel.bottomRows (panel.rows() - size);
    solveUnitLowerTransposedFromRight (panel.topRows (size), below);
    below *= pivots.segment (begin, size).cwiseInverse().asDiagonal();
}

void BlockBandedFactor::factorDiagonal (Eigen::Index block)
{
    auto diagonal = lower.panel (block).topRows (lower.size (block));

    for (Eigen::Index j = 0; j < diagonal.cols(); ++j)
    {
        checkWatch();
        const auto pivot = diagonal (j, j);
        const auto below = diagonal.cols() - j - 1;
        pivots[lower.begin (block) + j] = pivot;
        usable = usable && std::isfinite (pivot) && pivot != 0;
        const Eigen::VectorXd column = diagonal.col (j).tail (below) / pivot;

        for (Eigen::Index k = 0; k < below; ++k)
            diagonal.col (j + 1 + k).tail (below - k) -= pivot * column[k] * column.tail (below - k);

        diagonal.col (j).tail (below) = column;
    }
}

void BlockBandedFactor::solveInPlace (Eigen::MatrixXd& columns) const
{
    const auto own = [&] (Eigen::Index block) { return columns.middleRows (lower.begin (block), lower.size (block)); };
    const auto below = [&] (Eigen::Index block)
    { return columns.middleRows (lower.begin (block + 1), lower.panel (block).rows() - lower.size (block)); };

    for (Eigen::Index block = 0; block < lower.blocks(); ++block)
    {
        const auto& panel = lower.panel (block);
        solveUnitLower (panel.topRows (lower.size (block)), own (block));
        addProduct (below (block), -1, panel.bottomRows (panel.rows() - lower.size (block)), own (block));
    }

    columns.array().colwise() /= pivots.array();

    for (auto block = lower.blocks() - 1; block >= 0; --block)
    {
        const auto& panel = lower.panel (block);
        addTransposedLeft (own (block), -1, panel.bottomRows (panel.rows() - lower.size (block)), below (block));
        solveUnitLowerTransposed (panel.topRows (lower.size (block)), own (block));
    }
}
} // namespace antinode
