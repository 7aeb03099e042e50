#pragma once

#include "DenseKernels.h"

#include <Eigen/Core>

#include <optional>

namespace antinode
{
// What other rooms factor and solve by. Eigen's templates for it are compiled in this room alone: they take long.
// Docs/Design/engine.md.

/** The eigenvalues of a symmetric matrix, ascending.
    @param a  its lower triangle is used; finite
    @throws std::runtime_error  as symmetricEigen does
    [worker] */
Eigen::VectorXd symmetricEigenvalues (const Eigen::MatrixXd& a);

/** Numbers mu, ascending, and vectors x, one a column, with a x = mu b x and x' b x = 1.
    @param a  symmetric; its lower triangle is used
    @param b  positive definite; its lower triangle is used
    @return   nothing when b is not positive definite, or a number is not finite
    @throws std::runtime_error  as symmetricEigen does
    [worker] Golub, Van Loan, Matrix Computations, algorithm 8.7.1. */
std::optional<SymmetricEigen> generalizedEigen (Eigen::MatrixXd a, Eigen::MatrixXd b);

/** An eigenvalue and its eigenvector, of length 1. */
struct ComplexEigenpair
{
    double value = 0;
    Eigen::VectorXcd vector;
};

/** The largest eigenvalue of a Hermitian matrix.
    @param a  at least 1 x 1, finite
    @throws std::runtime_error  as symmetricEigen does
    [worker] */
ComplexEigenpair largestEigenpair (const Eigen::MatrixXcd& a);

/** The eigenvalues of any complex matrix, in no order.
    @return  nothing when the iteration does not converge
    [worker] */
std::optional<Eigen::VectorXcd> complexEigenvalues (const Eigen::MatrixXcd& a);

/** x with a x = b, by pivoted elimination; where a is singular, a solution if there is one.
    @param a  symmetric or Hermitian, semidefinite; its lower triangle is used
    [worker] */
Eigen::MatrixXd solveSemidefinite (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::MatrixXcd solveSemidefinite (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

/** A symmetric matrix as columns diag (pivots) columns', by elimination in the order of the diagonal, largest first. */
struct PivotedFactor
{
    Eigen::VectorXd pivots;
    Eigen::MatrixXd columns;
};

/** @param a  its lower triangle is used
    [worker] */
PivotedFactor pivotedFactor (const Eigen::MatrixXd& a);

/** R, upper triangular and square, with columns = Q R and Q orthonormal; zero below the last row of `columns`.
    [worker] */
Eigen::MatrixXd orthogonalTriangle (const Eigen::MatrixXd& columns);

/** An orthonormal basis, one vector a column, of what independent rows map to zero: N x (N - rows). [worker] */
Eigen::MatrixXd nullSpace (const Eigen::MatrixXd& rows);

/** Of all x with the least |a x - b| the shortest. [worker] */
Eigen::VectorXd leastSquares (const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

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
