#pragma once

#include "PathPiece.h"

#include <vector>

namespace antinode
{
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
} // namespace antinode
