#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** A line of equal values through a matrix: places as columns and rows, counted from 0 at the first value. A closed
   line ends where it starts. */
using ContourLine = std::vector<Eigen::Vector2d>;

/** All lines at a level, by marching squares: straight through each square of four values, where a saddle is cut as its
   mean says. Squares with a value that is not finite have none. The same lines in the same order on every run. [any] */
std::vector<ContourLine> contourLines (const Eigen::MatrixXd& values, double level);
} // namespace antinode
