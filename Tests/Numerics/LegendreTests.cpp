#include <antinode_numerics/Quadrature.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("the rules of Gauss and Lobatto integrate polynomials to degree 2 n - 3", "[structure]")
{
    for (const Eigen::Index count : { 2, 3, 5, 10, 33, 64 })
    {
        const auto rule = gaussLobattoRule (count);
        CAPTURE (count);
        CHECK (rule.places[0] == -1);
        CHECK (rule.places[count - 1] == 1);
        CHECK ((rule.places.tail (count - 1) - rule.places.head (count - 1)).minCoeff() > 0);

        for (Eigen::Index degree = 0; degree <= 2 * count - 3; ++degree)
        {
            const auto exact = degree % 2 == 0 ? 2.0 / static_cast<double> (degree + 1) : 0.0;
            const auto sum = rule.weights.dot (rule.places.array().pow (static_cast<double> (degree)).matrix());
            CHECK (sum == Approx (exact).margin (1e-14));
        }
    }
}

TEST_CASE ("Legendre polynomials are orthogonal", "[structure]")
{
    const auto rule = gaussLobattoRule (12);
    const auto p = legendrePolynomials (rule.places, 8);
    const Eigen::MatrixXd gram = p.transpose() * rule.weights.asDiagonal() * p;

    for (Eigen::Index n = 0; n < 8; ++n)
        for (Eigen::Index m = 0; m < 8; ++m)
            CHECK (gram (n, m) == Approx (n == m ? 2.0 / static_cast<double> (2 * n + 1) : 0.0).margin (1e-14));
}

TEST_CASE ("integrals of Legendre polynomials are what a quadrature from -1 gives", "[structure]")
{
    const auto rule = gaussLobattoRule (12);
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced (7, -1, 1);
    const auto integrals = legendreIntegrals (places, 8);

    for (Eigen::Index i = 0; i < places.size(); ++i)
    {
        const auto half = (places[i] + 1) / 2;
        const Eigen::VectorXd inner = (half * (rule.places.array() + 1) - 1).matrix();
        const Eigen::VectorXd weights = half * rule.weights;
        const Eigen::RowVectorXd once = weights.transpose() * legendrePolynomials (inner, 8);
        const Eigen::RowVectorXd twice = weights.transpose() * legendreIntegrals (inner, 8).once;
        CHECK ((integrals.once.row (i) - once).norm() < 1e-14);
        CHECK ((integrals.twice.row (i) - twice).norm() < 1e-14);
    }
}
