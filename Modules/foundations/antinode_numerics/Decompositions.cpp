#include "Decompositions.h"

#include "Householder.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace antinode
{
std::optional<SymmetricEigen> generalizedEigen (Eigen::MatrixXd a, Eigen::MatrixXd b)
{
    if (! factorLower (b))
        return std::nullopt;

    // C = L^-1 A L'^-1 has the same eigenvalues.
    a = Eigen::MatrixXd (a.selfadjointView<Eigen::Lower>());
    solveLower (b, a);
    solveLowerTransposedFromRight (b, a);

    if (! a.allFinite())
        return std::nullopt;

    auto eigen = symmetricEigen (std::move (a));
    solveLowerTransposed (b, eigen.vectors);
    return eigen;
}

ComplexEigenpair largestEigenpair (const Eigen::MatrixXcd& a)
{
    // The real matrix of the same map has each eigenvalue twice; any vector of the largest one serves.
    const auto size = a.rows();
    Eigen::MatrixXd real (2 * size, 2 * size);
    real << a.real(), -a.imag(), a.imag(), a.real();
    const auto [values, vectors] = symmetricEigen (std::move (real));
    ComplexEigenpair pair { values[2 * size - 1], Eigen::VectorXcd (size) };
    pair.vector.real() = vectors.col (2 * size - 1).head (size);
    pair.vector.imag() = vectors.col (2 * size - 1).tail (size);
    return pair;
}

Eigen::MatrixXd solveSemidefinite (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.ldlt().solve (b);
}

PivotedFactor pivotedFactor (const Eigen::MatrixXd& a)
{
    const auto factor = a.ldlt();
    const Eigen::MatrixXd triangle = factor.matrixL();
    return { factor.vectorD(), factor.transpositionsP().transpose() * triangle };
}

Eigen::MatrixXd orthogonalTriangle (const Eigen::MatrixXd& columns)
{
    const auto size = columns.cols(), filled = std::min (size, columns.rows());
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero (size, size);
    triangle.topRows (filled) = householderTriangle (columns);
    return triangle;
}

Eigen::MatrixXd nullSpace (const Eigen::MatrixXd& rows)
{
    const auto size = rows.cols();
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity (size, size).rightCols (size - rows.rows());

    if (rows.rows() > 0)
        basis.applyOnTheLeft (Eigen::HouseholderQR<Eigen::MatrixXd> (rows.transpose()).householderQ());

    return basis;
}

Eigen::VectorXd leastSquares (const Eigen::MatrixXd& a, const Eigen::VectorXd& b)
{
    constexpr Eigen::Index many = 64; // columns, from which on blocks of them are quicker
    const auto size = a.cols();

    if (size < many || a.rows() < 2 * size)
        return a.completeOrthogonalDecomposition().solve (b);

    // The triangle of both is the same problem with as many rows as columns.
    Eigen::MatrixXd both (a.rows(), size + 1);
    both << a, b;
    const auto triangle = orthogonalTriangle (both);
    return triangle.topLeftCorner (size, size)
        .completeOrthogonalDecomposition()
        .solve (triangle.col (size).head (size));
}
} // namespace antinode
