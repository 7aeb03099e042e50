#pragma once

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** Places of a surface as Python gives them: x and y, mm. */
using PlacePairs = std::vector<std::pair<double, double>>;

/** N x 2, m. @param name  of the argument
    @throws InputError  where there are none, or one is not finite [any] */
Eigen::MatrixX2d placesOf (const PlacePairs&, const std::string& name);

/** N x 2, mm, of places in m. [any] */
Eigen::MatrixX2d inMillimetres (const Eigen::MatrixX2d&);
} // namespace antinode
