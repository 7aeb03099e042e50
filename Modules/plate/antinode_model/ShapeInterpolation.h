#pragma once

#include "PlateGrid.h"

namespace antinode
{
/** Values between the points of a line: cubic Hermite from values and slopes. Docs/Theory.md, section 1.5.
    @param points  N_p, ascending, m
    @param values, slopes  N_p x N
    @param x       m; beyond the ends the end's value is given
    @return        N values
    [any] */
Eigen::RowVectorXd interpolateOnLine (const Eigen::VectorXd& points, const Eigen::MatrixXd& values,
                                      const Eigen::MatrixXd& slopes, double x);

/** The slope of what interpolateOnLine gives. [any] */
Eigen::RowVectorXd slopesOnLine (const Eigen::VectorXd& points, const Eigen::MatrixXd& values,
                                 const Eigen::MatrixXd& slopes, double x);

/** Slopes at the points of a line by the natural cubic spline through the values.
    @param points  N_p, strictly ascending
    @param values  N_p x N
    @return        N_p x N
    [worker] */
Eigen::MatrixXd naturalSplineSlopes (const Eigen::VectorXd& points, const Eigen::MatrixXd& values);

/** Values between the points of a grid: polynomials in x and y through the points of the segments that hold the place.
    @param values  N_p x N
    @return        N values
    [worker] Docs/Theory.md, section 1.5. */
Eigen::RowVectorXd interpolateOnGrid (const PlateGrid&, const Eigen::MatrixXd& values, double x, double y);

/** Values between scattered points of a plane: the thin-plate spline through the nearest 48 of them. Exact at the
   points.
    @param points  N_p x 2
    @param values  N_p x N
    @return        N values
    [worker] Docs/Theory.md, section 1.5. */
Eigen::RowVectorXd interpolateInPlane (const Eigen::MatrixX2d& points, const Eigen::MatrixXd& values, double x,
                                       double y);
} // namespace antinode
