#include "BlockBandedFactor.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** How far from its diagonal a matrix has entries. */
Eigen::Index bandwidth (const Eigen::MatrixXd& matrix)
{
    Eigen::Index band = 0;

    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
            if (matrix (i, j) != 0)
                band = std::max (band, std::abs (i - j));

    return band;
}

void addBand (MatrixOut to, double factor, const Eigen::MatrixXd& matrix, Eigen::Index band)
{
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    {
        const auto first = std::max<Eigen::Index> (j - band, 0);
        const auto count = std::min (j + band + 1, matrix.rows()) - first;
        to.col (j).segment (first, count) += factor * matrix.col (j).segment (first, count);
    }
}
} // namespace

BlockBandedFactor::BlockBandedFactor (const TensorOperator& stiffness, const TensorOperator& mass, double shift,
                                      const SplineAxis& outer)
    : blockSize (stiffness.innerRows), pivots (stiffness.innerRows * stiffness.outerRows)
{
    for (Eigen::Index block = 0; block < outer.size(); ++block)
    {
        checkWatch(); // Memory that is touched for the first time takes long.
        last.push_back (outer.lastNeighbour (block));
        panels.emplace_back (Eigen::MatrixXd::Zero ((last.back() - block + 1) * blockSize, blockSize));
    }

    addTerms (stiffness, 1);
    addTerms (mass, -shift);

    for (Eigen::Index block = 0; block < outer.size() && usable; ++block)
        eliminate (block);

    negatives = usable ? (pivots.array() < 0).count() : 0;
}

void BlockBandedFactor::addTerms (const TensorOperator& tensor, double factor)
{
    for (const auto& term : tensor.terms)
    {
        const auto band = bandwidth (term.inner);

        for (Eigen::Index j = 0; j < term.outer.cols(); ++j)
        {
            checkWatch();

            for (Eigen::Index i = j; i < term.outer.rows(); ++i)
                if (term.outer (i, j) != 0)
                    addBand (panels[static_cast<std::size_t> (term.outerColumn + j)].block (
                                 (i - j) * blockSize + term.innerRow, term.innerColumn, term.inner.rows(),
                                 term.inner.cols()),
                             factor * term.outer (i, j), term.inner, band);
        }
    }
}

void BlockBandedFactor::eliminate (Eigen::Index block)
{
    auto& panel = panels[static_cast<std::size_t> (block)];
    Eigen::MatrixXd scaled;

    for (auto before = block - 1; before >= 0 && last[static_cast<std::size_t> (before)] >= block; --before)
    {
        const auto& left = panels[static_cast<std::size_t> (before)];
        const auto offset = (block - before) * blockSize;
        const auto rows = left.rows() - offset;
        scaled = left.middleRows (offset, blockSize) * pivots.segment (before * blockSize, blockSize).asDiagonal();
        addTransposedRight (panel.topRows (rows), -1, left.bottomRows (rows), scaled);
    }

    factorDiagonal (panel.topRows (blockSize), block * blockSize);
    auto below = panel.bottomRows (panel.rows() - blockSize);
    solveUnitLowerTransposedFromRight (panel.topRows (blockSize), below);
    below *= pivots.segment (block * blockSize, blockSize).cwiseInverse().asDiagonal();
}

void BlockBandedFactor::factorDiagonal (MatrixOut diagonal, Eigen::Index firstPivot)
{
    for (Eigen::Index j = 0; j < blockSize; ++j)
    {
        checkWatch();
        const auto pivot = diagonal (j, j);
        const auto below = blockSize - j - 1;
        pivots[firstPivot + j] = pivot;
        usable = usable && std::isfinite (pivot) && pivot != 0;
        const Eigen::VectorXd column = diagonal.col (j).tail (below) / pivot;

        for (Eigen::Index k = 0; k < below; ++k)
            diagonal.col (j + 1 + k).tail (below - k) -= pivot * column[k] * column.tail (below - k);

        diagonal.col (j).tail (below) = column;
    }
}

void BlockBandedFactor::solveInPlace (Eigen::MatrixXd& columns) const
{
    const auto blocks = static_cast<Eigen::Index> (panels.size());
    const auto blockRows = [&] (Eigen::Index block, Eigen::Index first)
    {
        return columns.middleRows ((block + first) * blockSize,
                                   panels[static_cast<std::size_t> (block)].rows() - first * blockSize);
    };

    for (Eigen::Index block = 0; block < blocks; ++block)
    {
        const auto& panel = panels[static_cast<std::size_t> (block)];
        auto own = columns.middleRows (block * blockSize, blockSize);
        solveUnitLower (panel.topRows (blockSize), own);
        addProduct (blockRows (block, 1), -1, panel.bottomRows (panel.rows() - blockSize), own);
    }

    columns.array().colwise() /= pivots.array();

    for (auto block = blocks - 1; block >= 0; --block)
    {
        const auto& panel = panels[static_cast<std::size_t> (block)];
        auto own = columns.middleRows (block * blockSize, blockSize);
        addTransposedLeft (own, -1, panel.bottomRows (panel.rows() - blockSize), blockRows (block, 1));
        solveUnitLowerTransposed (panel.topRows (blockSize), own);
    }
}
} // namespace antinode
