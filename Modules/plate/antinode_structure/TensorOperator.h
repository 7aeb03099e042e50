#pragma once

#include <antinode_numerics/BlockBandedMatrix.h>
#include <antinode_numerics/SplineAxis.h>

#include <functional>
#include <vector>

namespace antinode
{
/** Integrals of products of the splines of two axes over a part of their cells: the splines that live there. */
struct SplineProducts
{
    Eigen::Index firstRow = 0, firstColumn = 0; ///< The first splines of either axis.
    Eigen::MatrixXd values;                     ///< integral B_i B_j
    Eigen::MatrixXd slopes;                     ///< integral B'_i B'_j
    Eigen::MatrixXd curvatures;                 ///< integral B''_i B''_j
    Eigen::MatrixXd curvatureValue;             ///< integral B''_i B_j
};

/** A smooth weight along an axis. */
using AxisWeight = std::function<double (double)>;

/** @param rows, columns        axes with the same breaks, of any degrees
    @param firstCell, endCell  the part: cells firstCell .. endCell - 1
    @param weight              in all integrals; none: 1
    [worker] Docs/Theory.md, section 1.6. */
SplineProducts splineProducts (const SplineAxis& rows, const SplineAxis& columns, Eigen::Index firstCell,
                               Eigen::Index endCell, const AxisWeight& weight = {});

/** outer x inner: an operator on fields of splines, from the unknowns of its columns to those of its rows. */
struct TensorTerm
{
    Eigen::Index outerRow = 0, outerColumn = 0, innerRow = 0, innerColumn = 0; ///< Where its blocks begin.
    Eigen::MatrixXd outer, inner;
};

/** A sum of such products. A field has the unknowns of an inner axis, fastest, by those of an outer one. */
struct TensorOperator
{
    Eigen::Index outerRows = 0, innerRows = 0, outerColumns = 0, innerColumns = 0;
    std::vector<TensorTerm> terms;

    /** @param fields  (innerColumns outerColumns) x N
        @return        (innerRows outerRows) x N
        [worker] */
    Eigen::MatrixXd operator() (const Eigen::MatrixXd& fields) const;
};

/** L D L' of stiffness - shift mass, symmetric operators of the same size. The unknowns of one outer spline are a
   block; blocks reach as far as outer splines overlap. [worker] */
BlockBandedFactor factorShifted (const TensorOperator& stiffness, const TensorOperator& mass, double shift,
                                 const SplineAxis& outer);
} // namespace antinode
