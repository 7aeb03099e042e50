#pragma once

#include "Outline.h"

namespace antinode
{
/** Makes a closed path of lines and arcs, one after the other from a first place. Lengths in m, angles in rad. */
class PathBuilder
{
public:
    explicit PathBuilder (const Eigen::Vector2d& start);

    /** A straight line to a place. */
    void lineTo (const Eigen::Vector2d& end, int edge);

    /** A part of a circle to a place, to the left of the straight line where the bulge is negative.
        @param bulge  the tangent of a quarter of the angle that it turns by, positive counter-clockwise: 1 is half a
       circle, 0 a straight line */
    void arcTo (const Eigen::Vector2d& end, double bulge, int edge);

    /** A part of an ellipse about a centre; it begins where the path is.
        @param cosine, sine  from the centre to the places at the angles 0 and pi / 2 */
    void ellipseTo (const Eigen::Vector2d& centre, const Eigen::Vector2d& cosine, const Eigen::Vector2d& sine,
                    double from, double to, int edge);

    /** The path, whose last piece ends at the first place; pieces of no length are left out. */
    ClosedPath close() const;

    /** Puts the end of what was drawn last to a place that differs from it by rounding. */
    void endAt (const Eigen::Vector2d& end);

    /** What was drawn so far, open, arcs uncut where x or y turns back. */
    const std::vector<PathPiece>& drawn() const { return pieces; }

private:
    Eigen::Vector2d first, place;
    ClosedPath pieces;
};

/** An outline whose pieces are cut where x or y turn back on them. [any] */
Outline withMonotonePieces (Outline);
} // namespace antinode
