#pragma once

#include "Outline.h"

#include <array>
#include <functional>

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

/** A smooth curve by a parameter. */
struct FreeCurve
{
    std::function<Eigen::Vector2d (double)> at;    ///< m
    std::function<Eigen::Vector2d (double)> slope; ///< Its derivative; it may vanish at ends.
};

/** Draws a curve as arcs and lines that leave the path smooth: pairs of arcs with the curve's tangents, halved until
   they lie within a deviation. The path is at the curve's start. [worker] K. M. Bolton, Biarc curves, Computer-Aided
   Design 7 (1975). */
void drawCurve (PathBuilder&, const FreeCurve&, double from, double to, double deviation, int edge);

/** Draws Bezier's cubic curve through four control points, the first of which is where the path is: as one arc of an
   ellipse where it is what programs write for one, else as drawCurve(). [worker] */
void drawBezier (PathBuilder&, const std::array<Eigen::Vector2d, 4>& points, double deviation, int edge);

// Paths of the usual shapes, counter-clockwise. Lengths in m, angles in rad counter-clockwise. [any]

/** A rectangle about its centre, with edges firstEdge (bottom), + 1 (right), + 2 (top) and + 3 (left). The corners
   belong to the edge that follows.
    @param radii  of the corners from the lower left one on, counter-clockwise */
ClosedPath rectanglePath (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle,
                          const std::array<double, 4>& radii, int firstEdge);

/** An ellipse about its centre, all of one edge. */
ClosedPath ellipsePath (const Eigen::Vector2d& centre, const Eigen::Vector2d& semiaxes, double angle, int edge);

ClosedPath circlePath (const Eigen::Vector2d& centre, double radius, int edge);

/** Straight lines through vertices and back to the first one; line i, which begins at vertex i, is edge firstEdge + i.
 */
ClosedPath polygonPath (const std::vector<Eigen::Vector2d>& vertices, int firstEdge);
} // namespace antinode
