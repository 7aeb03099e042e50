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
} // namespace antinode
