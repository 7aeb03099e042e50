#pragma once

#include <Eigen/Core>

#include <optional>

namespace antinode
{
/** A coordinate of the plane. */
enum class PlaneAxis
{
    x,
    y
};

/** A part of a closed path that neither x nor y turns back on: a straight line, or a part of a quadrant of an ellipse.
   Its points are centre + cosine cos t + sine sin t, of a line centre + cosine t. */
struct PathPiece
{
    Eigen::Vector2d start, end; ///< m; the end of a piece is the start of the next one, to the bit.
    Eigen::Vector2d centre, cosine, sine;
    double from = 0, to = 1; ///< t at the start and the end; it may descend.
    bool isStraight = true;
    int edge = 0; ///< Which edge of the outline it belongs to.

    /** The place at a parameter, m. [any] */
    Eigen::Vector2d at (double parameter) const;

    /** Its derivative by the parameter, m. [any] */
    Eigen::Vector2d derivative (double parameter) const;

    /** The parameter at which a coordinate has a value between those of the ends; the nearer end beyond them. [any] */
    double parameterAt (PlaneAxis, double value) const;

    /** The place where it crosses a line of equal x or y: of the line's other coordinate, m. Nothing where it does not;
       of two pieces that meet on the line one counts, so that a closed path is always crossed an even number of times.
       [any] */
    std::optional<double> crossing (PlaneAxis, double value) const;

    /** The nearest place of it. [any] */
    Eigen::Vector2d nearest (const Eigen::Vector2d& place) const;

    double least (PlaneAxis) const;
    double largest (PlaneAxis) const;

    /** Its length between two parameters, m. [any] */
    double length (double begin, double finish) const;
};

/** A straight piece. [any] */
PathPiece linePiece (const Eigen::Vector2d& start, const Eigen::Vector2d& end, int edge);
} // namespace antinode
