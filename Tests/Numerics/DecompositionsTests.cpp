#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>

using namespace antinode;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr auto nothing = std::numeric_limits<double>::quiet_NaN();

/** What rounding may make of numbers near 1 in matrices of some size, with conditions up to a thousand. */
constexpr auto tolerance = 1e-11;

double largestIn (const MatrixXcd& a)
{
    return a.size() > 0 ? a.cwiseAbs().maxCoeff() : 0;
}

MatrixXd positive (Index size)
{
    const MatrixXd a = MatrixXd::Random (size, size);
    return a * a.transpose() / static_cast<double> (size) + MatrixXd::Identity (size, size);
}

MatrixXcd positiveHermitian (Index size)
{
    const MatrixXcd a = MatrixXcd::Random (size, size);
    return a * a.adjoint() / static_cast<double> (size) + MatrixXcd::Identity (size, size);
}

/** With what no function may read above the diagonal. */
template <typename Matrix>
Matrix onlyLower (Matrix a)
{
    a.template triangularView<Eigen::StrictlyUpper>().setConstant (nothing);
    return a;
}
} // namespace

TEST_CASE ("Generalized eigenpairs satisfy their equation and are normalised", "[numerics][processors]")
{
    std::srand (21);

    for (const Index size : { 1, 2, 33, 70 })
    {
        const MatrixXd half = MatrixXd::Random (size, size), a = half + half.transpose(), b = positive (size);
        const auto pairs = generalizedEigen (onlyLower (a), onlyLower (b));
        REQUIRE (pairs);
        CHECK (std::is_sorted (pairs->values.begin(), pairs->values.end()));
        CHECK (largestIn (a * pairs->vectors - b * pairs->vectors * pairs->values.asDiagonal()) < tolerance);
        CHECK (largestIn (pairs->vectors.transpose() * b * pairs->vectors - MatrixXd::Identity (size, size))
               < tolerance);
    }

    CHECK_FALSE (generalizedEigen (positive (3), -positive (3)));
    CHECK_FALSE (generalizedEigen (MatrixXd::Constant (3, 3, nothing), positive (3)));
}

TEST_CASE ("Eigenvalues alone are those of a chain of springs", "[numerics][processors]")
{
    constexpr Index links = 40;
    MatrixXd chain = 2 * MatrixXd::Identity (links, links);
    chain.diagonal (-1).setConstant (-1);
    const auto values = symmetricEigenvalues (chain);

    for (Index k = 0; k < links; ++k)
        CHECK (values[k]
               == Approx (2 - 2 * std::cos (static_cast<double> (k + 1) * std::numbers::pi / (links + 1)))
                      .epsilon (1e-12));
}

TEST_CASE ("The largest eigenpair of a Hermitian matrix is the one it was made with", "[numerics][processors]")
{
    std::srand (22);

    for (const Index size : { 1, 2, 5, 12 })
    {
        const Eigen::VectorXcd strong = Eigen::VectorXcd::Random (size).normalized();
        const MatrixXcd a = 3 * strong * strong.adjoint() - 0.5 * MatrixXcd::Identity (size, size);
        const auto [value, vector] = largestEigenpair (a);
        CHECK (value == Approx (2.5));
        CHECK (vector.norm() == Approx (1));
        CHECK (std::abs (strong.dot (vector)) == Approx (1));
    }
}

TEST_CASE ("Complex eigenvalues make a matrix singular, and are all there are", "[numerics][processors]")
{
    std::srand (23);

    for (const Index size : { 1, 2, 40 })
    {
        const MatrixXcd a = MatrixXcd::Random (size, size);
        const auto values = complexEigenvalues (a);
        REQUIRE (values);
        REQUIRE (values->size() == size);
        CHECK (std::abs (values->sum() - a.trace()) < tolerance);
        CHECK (std::abs (values->array().square().sum() - (a * a).trace()) < tolerance * static_cast<double> (size));

        for (Index n = 0; n < size; ++n)
        {
            const MatrixXcd shifted = a - (*values)[n] * MatrixXcd::Identity (size, size);
            CHECK (Eigen::JacobiSVD<MatrixXcd> (shifted).singularValues().minCoeff() < tolerance);
        }
    }
}

TEST_CASE ("Systems are solved, singular ones too where they can be", "[numerics][processors]")
{
    std::srand (24);

    for (const Index size : { 1, 7, 50 })
    {
        const MatrixXd a = positive (size), x = MatrixXd::Random (size, 3);
        CHECK (largestIn (solveSemidefinite (onlyLower (a), a * x) - x) < tolerance);
        MatrixXd factor = onlyLower (a);
        REQUIRE (factorLower (factor));
        CHECK (largestIn (solveFactored (factor, a * x) - x) < tolerance);
        const MatrixXcd hermitian = positiveHermitian (size), y = MatrixXcd::Random (size, 3);
        CHECK (largestIn (solveSemidefinite (onlyLower (hermitian), hermitian * y) - y) < tolerance);
    }

    const MatrixXd thin = MatrixXd::Random (6, 3), singular = thin * thin.transpose();
    const MatrixXd right = singular * MatrixXd::Random (6, 2);
    CHECK (largestIn (singular * solveSemidefinite (singular, right) - right) < tolerance);
}

TEST_CASE ("A pivoted factor puts a matrix together again, a singular one too", "[numerics][processors]")
{
    std::srand (25);
    const MatrixXd scaled =
        VectorXd::LinSpaced (9, 0.1, 1).asDiagonal() * positive (9) * VectorXd::LinSpaced (9, 0.1, 1).asDiagonal();
    const auto [pivots, columns] = pivotedFactor (onlyLower (scaled));
    CHECK (largestIn (columns * pivots.asDiagonal() * columns.transpose() - scaled) < tolerance);
}

TEST_CASE ("Triangle and null space of rows and columns are orthogonal", "[numerics][processors]")
{
    std::srand (26);

    for (const auto& [rows, columns] : { std::pair<Index, Index> { 1, 1 }, { 40, 7 }, { 100, 50 }, { 3, 5 } })
    {
        const MatrixXd a = MatrixXd::Random (rows, columns);
        const auto triangle = orthogonalTriangle (a);
        REQUIRE (triangle.rows() == columns);
        REQUIRE (triangle.cols() == columns);
        CHECK (largestIn (triangle.triangularView<Eigen::StrictlyLower>().toDenseMatrix()) == 0);
        CHECK (largestIn (triangle.transpose() * triangle - a.transpose() * a) < tolerance);
    }

    const MatrixXd rows = MatrixXd::Random (3, 20);
    const auto basis = nullSpace (rows);
    REQUIRE (basis.cols() == 17);
    CHECK (largestIn (rows * basis) < tolerance);
    CHECK (largestIn (basis.transpose() * basis - MatrixXd::Identity (17, 17)) < tolerance);
    CHECK (nullSpace (MatrixXd (0, 4)) == MatrixXd::Identity (4, 4));
}

TEST_CASE ("A least-squares solution is the shortest with an error at right angles", "[numerics][processors]")
{
    std::srand (27);

    for (const Index size : { 4, 80 }) // Many columns are reduced to their triangle first.
    {
        const MatrixXd tall = MatrixXd::Random (3 * size, size);
        const VectorXd right = VectorXd::Random (3 * size), x = leastSquares (tall, right);
        CHECK (largestIn (tall.transpose() * (tall * x - right)) < tolerance);

        // Two equal columns: the shortest solution shares between them.
        MatrixXd repeated (3 * size, size + 1);
        repeated << tall, tall.col (size - 1);
        const VectorXd shared = leastSquares (repeated, right);
        CHECK (largestIn (shared.head (size - 1) - x.head (size - 1)) < tolerance);
        CHECK (largestIn (shared.tail (2) - VectorXd::Constant (2, x[size - 1] / 2)) < tolerance);
    }
}

TEST_CASE ("Complex products, factors and triangles are those of the definition", "[numerics][processors]")
{
    std::srand (28);

    for (const Index size : { 1, 5, 40 })
    {
        const MatrixXcd a = MatrixXcd::Random (3 * size, size), b = MatrixXcd::Random (3 * size, 4);
        CHECK (largestIn (productTransposedLeft (a, b) - a.transpose() * b) < tolerance);
        CHECK (largestIn (adjointGram (a) - a.adjoint() * a) < tolerance);
        const auto hermitian = positiveHermitian (size);
        auto factor = onlyLower (hermitian);
        REQUIRE (factorLower (factor));
        const MatrixXcd lower = factor.triangularView<Eigen::Lower>(), x = MatrixXcd::Random (size, 3);
        CHECK (largestIn (lower * lower.adjoint() - hermitian) < tolerance);
        MatrixXcd y = lower * x;
        solveLower (factor, y);
        CHECK (largestIn (y - x) < tolerance);
    }

    MatrixXcd indefinite = -positiveHermitian (4);
    CHECK_FALSE (factorLower (indefinite));
}

TEST_CASE ("A factor that breaks down shows where", "[numerics][processors]")
{
    std::srand (29);

    for (const Index failing : { 0, 3, 50 })
    {
        MatrixXd a = positive (70);
        a (failing, failing) = -1;
        REQUIRE_FALSE (factorLower (a));
        CHECK (a (failing, failing) == 0);
    }
}
