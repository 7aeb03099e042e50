#pragma once

#include "Outline.h"

#include <array>

namespace antinode
{
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
