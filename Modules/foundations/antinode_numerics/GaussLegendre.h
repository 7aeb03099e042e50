#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Nodes and weights of a quadrature: integral_0^1 f (x) dx = sum_i weights (i) f (nodes (i)). */
struct Quadrature
{
    Eigen::VectorXd nodes;   ///< Within 0 to 1, ascending.
    Eigen::VectorXd weights; ///< Sum 1.
};

/** Gauss and Legendre's quadrature on 0 to 1, cut into panels of equal width: exact on each panel for polynomials of
   degree 2 points - 1. The nodes are the zeros of the Legendre polynomial, by Newton's method.
    @param points, panels  1 or more
    [worker] Abramowitz, Stegun, Handbook of Mathematical Functions, 25.4.29. */
Quadrature gaussLegendre (int points, int panels);
} // namespace antinode
