#pragma once

#include <Eigen/Core>

namespace antinode
{
/** The breaks of splines with their continuity, and the conditions at their ends. */
struct SplineBreaks
{
    Eigen::VectorXd places;       ///< Ascending; cells lie between them.
    Eigen::VectorXi multiplicity; ///< Of the knots there: degree - multiplicity continuous derivatives.
    int heldAtStart = 0;          ///< How many derivatives, from the value on, vanish at the start: 0, 1 or 2.
    int heldAtEnd = 0;            ///< The same at the end.
};

/** Values or derivatives of the splines that do not vanish on a cell. */
struct SplineValues
{
    Eigen::Index first = 0; ///< The first of these splines.
    Eigen::MatrixXd values; ///< Places x splines.
};

/** The B-splines along an axis. Docs/Theory.md, section 1.6; de Boor, A Practical Guide to Splines,
    chapters IX, X. */
class SplineAxis
{
public:
    SplineAxis (const SplineBreaks&, int degree);

    /** Splines of another degree on the same breaks: as smooth as before where they may bend, and elsewhere as smooth
       as they can be. [any] */
    SplineAxis withDegree (int degree) const;

    /** How many splines there are. [any] */
    Eigen::Index size() const { return count; }
    int degree() const { return order - 1; }
    Eigen::Index cells() const { return breaks.places.size() - 1; }
    double cellStart (Eigen::Index cell) const { return breaks.places[cell]; }
    double cellLength (Eigen::Index cell) const { return breaks.places[cell + 1] - breaks.places[cell]; }

    /** The coefficients of the place itself, as a sum of the splines: the mean of the inner knots of each. [any] */
    double centre (Eigen::Index spline) const;

    /** The cell that holds a place; a break belongs to the cell at its right. [any] */
    Eigen::Index cellAt (double place) const;

    /** The last spline that shares a cell with the given one. [any] */
    Eigen::Index lastNeighbour (Eigen::Index spline) const;

    /** Derivatives of the splines at places of one cell.
        @param derivative  0 for values, up to the degree
        [any] */
    SplineValues onCell (Eigen::Index cell, const Eigen::VectorXd& at, int derivative) const;

    /** Derivatives of all splines at any places. @return places x splines [any] */
    Eigen::MatrixXd at (const Eigen::VectorXd& where, int derivative) const;

private:
    SplineBreaks breaks;
    int order;
    Eigen::VectorXd knots;
    Eigen::VectorXi lastKnot; ///< Of each cell: the index of the knot at its left.
    Eigen::Index count;
};
} // namespace antinode
