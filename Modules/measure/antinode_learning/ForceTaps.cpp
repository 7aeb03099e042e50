#include "ForceTaps.h"

namespace antinode
{
namespace
{
using Complex = std::complex<double>;
constexpr auto places = ForceTaps::places;
constexpr std::size_t moments = places + 1; // one more for the derivative

/** The coefficients of each place's cubic, which is 1 there and 0 at the others: of x^0 to x^3. */
constexpr std::array<std::array<double, places>, places> cubicsOfPlaces()
{
    std::array<std::array<double, places>, places> cubics {};

    for (std::size_t g = 0; g < places; ++g)
    {
        auto& cubic = cubics[g];
        cubic[0] = 1;

        for (std::size_t other = 0, degree = 0; other < places; ++other)
        {
            if (other == g)
                continue;

            const auto root = ForceTaps::gaussPlaces[other], width = ForceTaps::gaussPlaces[g] - root;
            ++degree;

            for (auto n = degree; n > 0; --n)
                cubic[n] = (cubic[n - 1] - root * cubic[n]) / width;

            cubic[0] *= -root / width;
        }
    }

    return cubics;
}

/** The integrals over 0 to 1 of exp (z (1 - x)) x^n. By parts z M_n = n M_(n-1) - 1: upwards where z is large,
    downwards from far above where it is small, since each loses its digits in the other case. */
std::array<Complex, moments> exponentialMoments (Complex z)
{
    constexpr double large = 4;
    constexpr std::size_t farAbove = 48; // start from 0: what is left of it, large^48 / 48!, is below rounding
    std::array<Complex, moments> values;

    if (std::abs (z) > large)
    {
        values[0] = (std::exp (z) - 1.0) / z;

        for (std::size_t n = 1; n < moments; ++n)
            values[n] = (static_cast<double> (n) * values[n - 1] - 1.0) / z;

        return values;
    }

    Complex moment = 0;

    for (auto n = farAbove; n > 0; --n)
    {
        moment = (z * moment + 1.0) / static_cast<double> (n);

        if (n <= moments)
            values[n - 1] = moment;
    }

    return values;
}
} // namespace

ForceTaps forceTaps (Complex pole, double length)
{
    static constexpr auto cubics = cubicsOfPlaces();
    const auto integrals = exponentialMoments (pole * length);
    ForceTaps result {};

    for (std::size_t g = 0; g < places; ++g)
        for (std::size_t n = 0; n < places; ++n)
        {
            result.taps[g] += length * cubics[g][n] * integrals[n];
            result.byPole[g] += length * length * cubics[g][n] * (integrals[n] - integrals[n + 1]);
        }

    return result;
}
} // namespace antinode
