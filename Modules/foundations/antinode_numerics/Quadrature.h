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

/** Places in -1..1 and their weights: the integral of f is sum weights f (places). */
struct QuadratureRule
{
    Eigen::VectorXd places, weights;
};

/** The rule of Gauss and Lobatto: both ends are among the places, polynomials to degree 2 count - 3 are integrated
   exactly.
    @param count  at least 2. [any] */
QuadratureRule gaussLobattoRule (Eigen::Index count);

/** Legendre polynomials P_0 .. P_{count-1}, one per column, at positions in -1..1, one per row. [any] */
Eigen::MatrixXd legendrePolynomials (const Eigen::VectorXd& places, Eigen::Index count);

/** Their derivatives. [any] */
Eigen::MatrixXd legendreSlopes (const Eigen::VectorXd& places, Eigen::Index count);

/** Legendre polynomials integrated from -1, once and twice. */
struct LegendreIntegrals
{
    Eigen::MatrixXd once, twice; ///< Places x polynomials.
};

/** The integrals of P_0 .. P_{count-1} from -1 to each of the places. [any] */
LegendreIntegrals legendreIntegrals (const Eigen::VectorXd& places, Eigen::Index count);
} // namespace antinode
