#include <antinode_numerics/Quadrature.h>

#include <Support/AdaptiveOde.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("the adaptive solution follows a kicked and driven oscillation to 1e-11")
{
    // y' = s y + 1 for 1 <= t < 2, else y' = s y, from 1: y (3) = e^{3s} + (e^{2s} - e^{s}) / s
    const std::complex<double> s (-0.7, 300);
    const auto derivative = [&] (double time, const Eigen::VectorXd& y)
    {
        const auto slope = s * std::complex<double> (y[0], y[1]) + (time >= 1 && time < 2 ? 1.0 : 0.0);
        return Eigen::VectorXd (Eigen::Vector2d (slope.real(), slope.imag()));
    };
    const auto exact = std::exp (3.0 * s) + (std::exp (2.0 * s) - std::exp (s)) / s;
    const auto state = integrateOde (derivative, Eigen::Vector2d (1, 0), 0, 3, 1e-13, { 2, 1, 7 });
    CHECK (std::abs (std::complex<double> (state[0], state[1]) - exact) < 1e-11);
}

TEST_CASE ("Gauss and Legendre's quadrature of n points is exact to degree 2 n - 1")
{
    for (const auto points : { 1, 2, 5, 16, 24 })
    {
        for (const auto panels : { 1, 3 })
        {
            const auto quadrature = gaussLegendre (points, panels);
            for (int degree = 0; degree < 2 * points; ++degree)
            {
                const auto integral = quadrature.weights.dot (quadrature.nodes.array().pow (degree).matrix());
                CHECK (integral == Approx (1.0 / (degree + 1)).epsilon (1e-14).margin (1e-15));
            }
        }
    }
}

TEST_CASE ("the nodes of Gauss and Legendre's quadrature are the published ones")
{
    // Abramowitz, Stegun, table 25.4, n = 3: 0.774596669241483, weights 5/9, 8/9, here on 0 to 1
    const auto quadrature = gaussLegendre (3, 1);
    CHECK (quadrature.nodes[0] == Approx ((1 - 0.774596669241483) / 2).epsilon (1e-14));
    CHECK (quadrature.nodes[1] == Approx (0.5).epsilon (1e-15));
    CHECK (quadrature.weights[0] == Approx (5.0 / 18).epsilon (1e-14));
    CHECK (quadrature.weights[1] == Approx (8.0 / 18).epsilon (1e-14));
}
