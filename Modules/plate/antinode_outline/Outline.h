#pragma once

#include <Eigen/Core>
#include <antinode_base/Reflection.h>

#include <optional>
#include <vector>

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

/** A closed path: every piece begins where the one before it ends. */
using ClosedPath = std::vector<PathPiece>;

/** A part of the plane: what lies inside an odd number of its paths. The first path is the outer one, the others are
   holes. Paths neither cross nor touch each other nor themselves. */
struct Outline
{
    std::vector<ClosedPath> paths;

    /** Whether a place lies inside; on the boundary either. [any] */
    bool contains (double x, double y) const;
};

/** A rectangle along the axes that holds an outline, m. */
struct OutlineExtent
{
    Eigen::Vector2d least, largest;

    Eigen::Vector2d size() const { return largest - least; }
};

/** [any] */
OutlineExtent extentOf (const Outline&);

/** m^2, without the holes. [any] */
double areaOf (const Outline&);

/** How much a path encloses, m^2: positive where it runs counter-clockwise. [any] */
double signedArea (const ClosedPath&);

/** 1 where the inside of an outline lies at the left of one of its paths, else -1. [any] */
double insideAtLeft (const Outline&, const ClosedPath& path);

/** The length of all pieces of an edge, m. [any] */
double lengthOfEdge (const Outline&, int edge);

/** An outline turned counter-clockwise about the origin by an angle, then shifted. [any] */
Outline moved (const Outline&, double angle, const Eigen::Vector2d& shift);

/** The same, larger by a factor about the origin. [any] */
Outline scaled (const Outline&, double factor);

/** The places at which an outline is crossed by a line of equal x or y, ascending; between an even one and the next it
   is inside. [any] */
std::vector<double> crossings (const Outline&, PlaneAxis, double value);

/** The nearest place of the boundary; of an outline without one the place itself. [any] */
Eigen::Vector2d nearestOnBoundary (const Outline&, double x, double y);

/** The nearest distance from a place to the boundary, m. [any] */
double distanceToBoundary (const Outline&, double x, double y);

/** All fields of an outline, in the order of their declaration, to be written or read. [any] */
void fields (auto& stream, Struct<PathPiece> auto& piece)
{
    auto& [start, end, centre, cosine, sine, from, to, isStraight, edge] = piece;

    for (auto* const vector : { &start, &end, &centre, &cosine, &sine })
        stream ((*vector)[0], (*vector)[1]);

    stream (from, to, isStraight, edge);
}

void fields (auto& stream, Struct<Outline> auto& outline)
{
    auto& [paths] = outline;
    stream (paths);
}

/** An outline of which the part from one place of a path to another, counter-clockwise, is an edge of its own. The
   places are those of the boundary that are nearest to the given ones.
    @return  nothing where the two lie on different paths
    [any] */
std::optional<Outline> withEdgeAlong (Outline, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int edge);

/** The largest number of an edge. [any] */
int lastEdge (const Outline&);
} // namespace antinode
