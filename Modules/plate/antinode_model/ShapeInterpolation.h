#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Places along one side of a plate, in segments that meet where the section changes. Within a segment shapes are
   smooth, so the polynomial through its places gives them in between. */
struct GridAxis
{
    Eigen::VectorXd places;  ///< Ascending, m: in each segment those of Gauss and Legendre.
    Eigen::VectorXd weights; ///< Of the places, m: the integral of f is sum weights f (places).
    Eigen::VectorXd edges;   ///< Of the segments, m; one more than these.
    Eigen::VectorXi first;   ///< The first place of each segment, and last the number of places.
};

/** A surface's points as the product of two axes: point i + j * x.places.size() lies at (x.places[i], y.places[j]). */
struct PlateGrid
{
    GridAxis x, y;
};

/** An axis of the given segments with the given number of places in each. [any]
    @param edges   of the segments, ascending, m
    @param counts  places in each, at least 1 */
GridAxis gridAxis (const Eigen::VectorXd& edges, const Eigen::VectorXi& counts);

/** The rows that take values at the places of an axis to other places on it: Lagrange's polynomials in barycentric
   form.
    @param at  m; beyond the ends the polynomial of the last segment is extrapolated
    @return    one row per position of `at`, one column per position of the axis
    [any] Docs/Theory.md, section 1.5. */
Eigen::MatrixXd interpolationRows (const GridAxis&, const Eigen::VectorXd& at);

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
