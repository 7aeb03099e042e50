#include "KaiserSinc.h"

#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** The modified Bessel function I0 (x) from r = (x/2)^2: the series sum_k r^k / k!^2, all terms positive. */
double besselI0 (double r)
{
    double term = 1, sum = 1;

    for (int k = 1; term > 1e-17 * sum; ++k)
    {
        term *= r / (static_cast<double> (k) * k);
        sum += term;
    }

    return sum;
}

/** sin (pi x) / (pi x), without cancellation near the integers. */
double sinc (double x)
{
    const auto nearest = std::nearbyint (x);

    if (x == 0)
        return 1;

    const auto sign = std::fmod (nearest, 2.0) == 0 ? 1.0 : -1.0;
    return sign * std::sin (std::numbers::pi * (x - nearest)) / (std::numbers::pi * x);
}
} // namespace

double kaiserSinc (double x)
{
    const auto u = x / kaiserSincHalfWidth;

    if (std::abs (u) >= 1)
        return 0;

    constexpr auto quarter = kaiserSincShape * kaiserSincShape / 4;
    static const double atCentre = besselI0 (quarter);
    return sinc (x) * besselI0 (quarter * (1 - u * u)) / atCentre;
}

double kaiserSinc (double x, double halfWidth, double shape)
{
    const auto u = x / halfWidth;
    const auto quarter = shape * shape / 4;
    return std::abs (u) < 1 ? sinc (x) * besselI0 (quarter * (1 - u * u)) / besselI0 (quarter) : 0;
}
} // namespace antinode
