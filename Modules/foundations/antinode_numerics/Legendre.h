#pragma once

#include <Eigen/Core>

namespace antinode
{
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
