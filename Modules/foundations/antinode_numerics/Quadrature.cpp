#include "Quadrature.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace antinode
{
namespace
{
struct LegendreValue
{
    double value = 0, slope = 0;
};

/** P_n and its derivative at x, |x| < 1, by the three-term recurrence. */
LegendreValue legendre (int n, double x)
{
    double before = 0, now = 1;

    for (int k = 1; k <= n; ++k)
    {
        const auto next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now;
        now = next;
    }

    return { now, n * (x * now - before) / (x * x - 1) };
}

/** One panel, on -1 to 1. */
Quadrature onePanel (int points)
{
    Quadrature panel { Eigen::VectorXd (points), Eigen::VectorXd (points) };
    constexpr int newtonSteps = 8; // quadratic from a start that is good to 1e-2: converged after 4
    constexpr auto converged = 1e-13;

    for (int i = 0; i < points; ++i)
    {
        auto x = -std::cos (std::numbers::pi * (i + 0.75) / (points + 0.5)), last = 1.0;

        for (int step = 0; step < newtonSteps; ++step)
        {
            const auto p = legendre (points, x);
            last = p.value / p.slope;
            x -= last;
        }

        if (! (std::abs (last) < converged))
            throw std::runtime_error ("places of Gauss and Legendre: no convergence");

        const auto slope = legendre (points, x).slope;
        panel.nodes[i] = x;
        panel.weights[i] = 2 / ((1 - x * x) * slope * slope);
    }

    return panel;
}
} // namespace

Quadrature gaussLegendre (int points, int panels)
{
    const auto panel = onePanel (points);
    Quadrature all { Eigen::VectorXd (points * panels), Eigen::VectorXd (points * panels) };

    for (Eigen::Index p = 0; p < panels; ++p)
    {
        all.nodes.segment (p * points, points) =
            (panel.nodes.array() + static_cast<double> (2 * p + 1)) / (2.0 * panels);
        all.weights.segment (p * points, points) = panel.weights / (2.0 * panels);
    }

    return all;
}

QuadratureRule gaussLobattoRule (Eigen::Index count)
{
    // The places are the zeros of (1 - x^2) P'_n (x), n = count - 1: Newton's method, from the zeros of Chebyshev's
    // polynomials.
    constexpr int newtonSteps = 12;
    constexpr auto converged = 1e-12;
    const auto n = count - 1;
    const auto degree = static_cast<double> (n);
    Eigen::VectorXd x = -Eigen::ArrayXd::LinSpaced (count, 0, std::numbers::pi).cos(), change;

    for (int step = 0; step < newtonSteps; ++step)
    {
        const Eigen::MatrixXd p = legendrePolynomials (x, count);
        change =
            ((x.array() * p.col (n).array() - p.col (n - 1).array()) / ((degree + 1) * p.col (n).array())).matrix();
        x -= change;
    }

    if (! (change.lpNorm<Eigen::Infinity>() < converged))
        throw std::runtime_error ("places of Gauss and Lobatto: no convergence");

    x[0] = -1;
    x[n] = 1;
    const Eigen::VectorXd last = legendrePolynomials (x, count).col (n);
    return { x, (2 / (degree * (degree + 1) * last.array().square())).matrix() };
}

Eigen::MatrixXd legendrePolynomials (const Eigen::VectorXd& places, Eigen::Index count)
{
    Eigen::MatrixXd p (places.size(), count);
    p.col (0).setOnes();

    if (count > 1)
        p.col (1) = places;

    for (Eigen::Index n = 2; n < count; ++n)
    {
        const auto degree = static_cast<double> (n);
        p.col (n) = ((2 * degree - 1) * places.cwiseProduct (p.col (n - 1)) - (degree - 1) * p.col (n - 2)) / degree;
    }

    return p;
}

Eigen::MatrixXd legendreSlopes (const Eigen::VectorXd& places, Eigen::Index count)
{
    // P_n' = P_{n-2}' + (2 n - 1) P_{n-1}.
    const auto p = legendrePolynomials (places, count);
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero (places.size(), count);

    for (Eigen::Index n = 1; n < count; ++n)
    {
        slopes.col (n) = static_cast<double> (2 * n - 1) * p.col (n - 1);

        if (n > 1)
            slopes.col (n) += slopes.col (n - 2);
    }

    return slopes;
}

LegendreIntegrals legendreIntegrals (const Eigen::VectorXd& places, Eigen::Index count)
{
    // The integral of P_n from -1 is (P_{n+1} - P_{n-1}) / (2 n + 1); used twice.
    const auto p = legendrePolynomials (places, count + 2);
    const auto divisor = [] (Eigen::Index n) { return static_cast<double> (2 * n + 1); };
    Eigen::MatrixXd once (places.size(), count + 1);
    Eigen::MatrixXd twice (places.size(), count);
    once.col (0) = (places.array() + 1).matrix();
    twice.col (0) = once.col (0).cwiseAbs2() / 2;

    for (Eigen::Index n = 1; n <= count; ++n)
        once.col (n) = (p.col (n + 1) - p.col (n - 1)) / divisor (n);

    for (Eigen::Index n = 1; n < count; ++n)
        twice.col (n) = (once.col (n + 1) - once.col (n - 1)) / divisor (n);

    return { once.leftCols (count), twice };
}
} // namespace antinode
