#include "TensorOperator.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
/** Grows a range of splines so that it holds another. */
struct SplineRange
{
    Eigen::Index first = 0, end = 0;

    static SplineRange of (const SplineAxis& axis, Eigen::Index firstCell, Eigen::Index endCell)
    {
        const Eigen::VectorXd none (0);
        const auto low = axis.onCell (firstCell, none, 0);
        const auto high = axis.onCell (endCell - 1, none, 0);
        return { low.first, high.first + high.values.cols() };
    }

    Eigen::Index size() const { return end - first; }
};

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

void addTerms (BlockBandedMatrix& matrix, const TensorOperator& tensor, double factor)
{
    for (const auto& term : tensor.terms)
    {
        const auto band = bandwidth (term.inner);

        for (Eigen::Index j = 0; j < term.outer.cols(); ++j)
        {
            checkWatch();

            for (Eigen::Index i = j; i < term.outer.rows(); ++i)
                if (term.outer (i, j) != 0)
                    addBand (matrix.panel (term.outerColumn + j)
                                 .block ((i - j) * tensor.innerRows + term.innerRow, term.innerColumn,
                                         term.inner.rows(), term.inner.cols()),
                             factor * term.outer (i, j), term.inner, band);
        }
    }
}
} // namespace

SplineProducts splineProducts (const SplineAxis& rows, const SplineAxis& columns, Eigen::Index firstCell,
                               Eigen::Index endCell, const AxisWeight& weight)
{
    const auto rowRange = SplineRange::of (rows, firstCell, endCell);
    const auto columnRange = SplineRange::of (columns, firstCell, endCell);
    const auto rule = gaussLegendre (std::max (rows.degree(), columns.degree()) + 1, 1);
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero (rowRange.size(), columnRange.size());
    SplineProducts products { rowRange.first, columnRange.first, zero, zero, zero, zero };

    for (auto cell = firstCell; cell < endCell; ++cell)
    {
        const auto length = rows.cellLength (cell);
        const Eigen::VectorXd places = (rows.cellStart (cell) + length * rule.nodes.array()).matrix();
        Eigen::VectorXd weights = length * rule.weights;

        if (weight)
            weights.array() *= places.unaryExpr (weight).array();

        const auto add = [&] (Eigen::MatrixXd& to, int rowDerivative, int columnDerivative)
        {
            const auto row = rows.onCell (cell, places, rowDerivative);
            const auto column = columns.onCell (cell, places, columnDerivative);
            to.block (row.first - rowRange.first, column.first - columnRange.first, row.values.cols(),
                      column.values.cols()) +=
                (row.values.transpose() * weights.asDiagonal()).lazyProduct (column.values);
        };
        add (products.values, 0, 0);
        add (products.slopes, 1, 1);
        add (products.curvatures, 2, 2);
        add (products.curvatureValue, 2, 0);
    }

    return products;
}

Eigen::MatrixXd TensorOperator::operator() (const Eigen::MatrixXd& fields) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (innerRows * outerRows, fields.cols());
    Eigen::MatrixXd half;

    for (Eigen::Index k = 0; k < fields.cols(); ++k)
    {
        const Eigen::Map<const Eigen::MatrixXd> from (fields.col (k).data(), innerColumns, outerColumns);
        Eigen::Map<Eigen::MatrixXd> to (result.col (k).data(), innerRows, outerRows);

        for (const auto& term : terms)
        {
            half.setZero (term.inner.rows(), term.outer.cols());
            addProduct (half, 1, term.inner,
                        from.block (term.innerColumn, term.outerColumn, term.inner.cols(), term.outer.cols()));
            addTransposedRight (to.block (term.innerRow, term.outerRow, term.inner.rows(), term.outer.rows()), 1, half,
                                term.outer);
        }
    }

    return result;
}

BlockBandedFactor factorShifted (const TensorOperator& stiffness, const TensorOperator& mass, double shift,
                                 const SplineAxis& outer)
{
    std::vector<Eigen::Index> reach;

    for (Eigen::Index block = 0; block < outer.size(); ++block)
        reach.push_back (outer.lastNeighbour (block));

    const std::vector<Eigen::Index> sizes (reach.size(), stiffness.innerRows);
    BlockBandedMatrix matrix (sizes, reach);
    addTerms (matrix, stiffness, 1);
    addTerms (matrix, mass, -shift);
    return BlockBandedFactor (std::move (matrix));
}
} // namespace antinode
