#pragma once

#include <Eigen/Core>

namespace antinode
{
/** How many values of a smooth function stand for all of it on some neighbouring lines. */
constexpr Eigen::Index smoothNodes = 16;

/** From how many half lengths of its lines' range on a pole leaves a function smooth: the error of its interpolation is
    (3 + sqrt 8)^-16 = 5e-13. */
constexpr double smoothDistance = 3;

/** Below so many lines nodes save nothing. */
constexpr Eigen::Index fewLines = 4 * smoothNodes;

/** Chebyshev's nodes of a range of frequencies. @return smoothNodes, rad/s, descending [any] */
Eigen::VectorXd chebyshevNodes (double centre, double halfWidth);

/** The polynomials that are 1 at one of Chebyshev's nodes and 0 at the others: what takes values at the nodes to values
    anywhere.
    @param at     N, rad/s
    @param nodes  from chebyshevNodes
    @return       N x smoothNodes
    [any] Docs/Theory.md, section 8.4. */
Eigen::MatrixXd interpolation (const Eigen::VectorXd& at, const Eigen::VectorXd& nodes);
} // namespace antinode
