#include "GaussLegendre.h"

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
} // namespace antinode
