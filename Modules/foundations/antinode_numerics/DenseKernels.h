#pragma once

#include <Eigen/Core>

namespace antinode
{
// Dense kernels for complex matrices, by products of the real and imaginary parts.
// Docs/Design/engine.md.

/** a' b, a transposed and not conjugated. [worker] */
Eigen::MatrixXcd productTransposedLeft (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

/** a* a, a* being the conjugate transpose. [worker] */
Eigen::MatrixXcd adjointGram (const Eigen::MatrixXcd& a);

/** Factors a positive definite Hermitian matrix, a = L L*: L replaces the lower triangle of a; above it all stays.
    @return  false when it is not positive definite
    [worker] */
bool factorLower (Eigen::MatrixXcd& a);

/** x = L^-1 x, L the lower triangle of a. [worker] */
void solveLower (const Eigen::MatrixXcd& a, Eigen::MatrixXcd& x);

// What the solution of plates and the allocation spend their time on, by the widest vectors of the processor it runs
// on, on the thread that calls; any number of threads may. All matrices are column by column, a part of a larger one or
// whole. Docs/Design/engine.md.
using MatrixIn = Eigen::Ref<const Eigen::MatrixXd>;
using MatrixOut = Eigen::Ref<Eigen::MatrixXd>;

/** to += factor a b. [worker] */
void addProduct (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b);

/** to += factor a' b. [worker] */
void addTransposedLeft (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b);

/** to += factor a b'. [worker] */
void addTransposedRight (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b);

/** The lower triangle of to += factor a a'. [worker] */
void addGram (MatrixOut to, double factor, const MatrixIn& a);

/** Factors a positive definite matrix, a = L L': L replaces the lower triangle of a; above it nothing is read or
   written.
    @return  false when it is not positive definite; the first pivot that is not positive is then 0
    [worker] */
bool factorLower (Eigen::MatrixXd& a);

/** x = L^-1 x, L the lower triangle of a. [worker] */
void solveLower (const MatrixIn& a, MatrixOut x);

/** x = L'^-1 x, L the lower triangle of a. [worker] */
void solveLowerTransposed (const MatrixIn& a, MatrixOut x);

/** x = x L'^-1, L the lower triangle of a. [worker] */
void solveLowerTransposedFromRight (const MatrixIn& a, MatrixOut x);

/** The solution of L L' x = right, L the lower triangle of a, as factorLower leaves it. [worker] */
Eigen::MatrixXd solveFactored (const MatrixIn& a, Eigen::MatrixXd right);

/** x = L^-1 x, L the lower triangle of a with ones on its diagonal. [worker] */
void solveUnitLower (const MatrixIn& a, MatrixOut x);

/** x = L'^-1 x, L the lower triangle of a with ones on its diagonal. [worker] */
void solveUnitLowerTransposed (const MatrixIn& a, MatrixOut x);

/** x = x L'^-1, L the lower triangle of a with ones on its diagonal. [worker] */
void solveUnitLowerTransposedFromRight (const MatrixIn& a, MatrixOut x);

/** The eigenvalues of a symmetric matrix, ascending, and its eigenvectors, orthonormal, one a column. */
struct SymmetricEigen
{
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/** @param a  its lower triangle is used; finite
    @throws std::runtime_error  when the iteration does not converge, or a number is not finite
    [worker] */
SymmetricEigen symmetricEigen (Eigen::MatrixXd a);
} // namespace antinode
