#include "BlockBandedFactor.h"

#include "DenseKernels.h"

#include <antinode_base/Watch.h>

#include <cmath>
#include <utility>

namespace antinode
{
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
