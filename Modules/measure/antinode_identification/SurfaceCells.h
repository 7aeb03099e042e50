#pragma once

#include <antinode_outline/Outline.h>

namespace antinode
{
/** The share of a line that each point stands for: half the distances to its neighbours; 1 of a point that
    is alone. @param x N, ascending, m @return N, m [worker] */
Eigen::VectorXd lineCells (const Eigen::VectorXd& x);

/** The area of each point's Voronoi cell, cut off at the rectangle around all points.
    @param points  N x 2, m @return N, m^2; 0 is possible for points on the boundary of a few points only
    [worker] */
Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points);

/** The same, cut off at an outline and its holes; arcs count as sixteen chords each. [worker] */
Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points, const Outline&);
} // namespace antinode
