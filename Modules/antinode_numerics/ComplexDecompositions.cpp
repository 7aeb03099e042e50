#include "Decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace antinode
{
std::optional<ComplexEigen> complexEigen (const Eigen::MatrixXcd& a)
{
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> eigen (a);

    if (eigen.info() != Eigen::Success)
        return std::nullopt;

    return ComplexEigen { eigen.eigenvalues(), eigen.eigenvectors() };
}

Eigen::MatrixXcd solveSemidefinite (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
    return a.ldlt().solve (b);
}
} // namespace antinode
