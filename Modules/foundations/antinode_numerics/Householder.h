#pragma once

#include <Eigen/Core>

namespace antinode
{
/** R of columns = Q R, by Householder's reflections: as many rows as `columns`, at most as many as it has columns. Its
   diagonal may be negative.
    @throws Cancelled  as checkWatch()
    [worker] Golub, Van Loan, Matrix Computations, algorithm 5.2.2. */
Eigen::MatrixXd householderTriangle (Eigen::MatrixXd columns);

/** A symmetric tridiagonal matrix T, and the factors of the reflections that led to it. */
struct Tridiagonal
{
    Eigen::VectorXd diagonal, beside, factors;
};

/** T of a symmetric matrix a = Q T Q'.
    @param a  square, not empty; its lower triangle is used, and then holds the reflections
    @throws Cancelled  as checkWatch()
    [worker] Golub, Van Loan, Matrix Computations, algorithm 8.3.1. */
Tridiagonal tridiagonalise (Eigen::MatrixXd& a);

/** Q of it.
    @param a  as tridiagonalise left it
    [worker] */
Eigen::MatrixXd accumulateReflections (const Eigen::MatrixXd& a, const Tridiagonal&);
} // namespace antinode
