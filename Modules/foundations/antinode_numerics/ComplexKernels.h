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
} // namespace antinode
