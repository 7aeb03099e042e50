#include "Decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace antinode
{
std::optional<Eigen::VectorXcd> complexEigenvalues (const Eigen::MatrixXcd& a)
{
    const Eigen::ComplexSchur<Eigen::MatrixXcd> schur (a, false);

    if (schur.info() != Eigen::Success)
        return std::nullopt;

    return Eigen::VectorXcd (schur.matrixT().diagonal());
}

Eigen::MatrixXcd solveSemidefinite (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
    return a.ldlt().solve (b);
}
} // namespace antinode
