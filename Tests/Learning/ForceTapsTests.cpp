#include <antinode_learning/MovingMode.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

using namespace antinode;
using Complex = std::complex<double>;

namespace
{
constexpr double length = 1e-3; // s
constexpr auto places = ForceTaps::places;

/** Any cubic. */
double cubicAt (double x)
{
    return 0.3 - 1.7 * x + 2.1 * x * x - 0.9 * x * x * x;
}

/** What the cubic adds to a mode, by Simpson's rule with many pieces: length times the integral of
    exp (z (1 - x)) cubic (x). */
Complex integrated (Complex z)
{
    constexpr int pieces = 20000;
    const auto at = [z] (double x) { return std::exp (z * (1 - x)) * cubicAt (x); };
    Complex sum = at (0) + at (1);

    for (int i = 1; i < pieces; ++i)
        sum += (i % 2 == 1 ? 4.0 : 2.0) * at (static_cast<double> (i) / pieces);

    return length * sum / (3.0 * pieces);
}

Complex added (const std::array<Complex, places>& taps)
{
    Complex sum = 0;

    for (std::size_t g = 0; g < places; ++g)
        sum += taps[g] * cubicAt (ForceTaps::gaussPlaces[g]);

    return sum;
}
} // namespace

TEST_CASE ("What a cubic force adds to a mode is its integral, however often the mode turns meanwhile", "[learning]")
{
    // From a small part of a turn through both sides of where the recursion of the moments changes to 40 turns.
    for (const auto z : { Complex (-1e-6, 1e-4), Complex (-0.01, 1), Complex (-0.05, 3.99), Complex (-0.05, 4.01),
                          Complex (-0.5, 15), Complex (-2, 250) })
    {
        const auto right = integrated (z);
        CAPTURE (z);
        CHECK (std::abs (added (forceTaps (z / length, length).taps) - right) < 1e-11 * length);
    }
}

TEST_CASE ("Changes of the taps by the pole are their differences", "[learning]")
{
    for (const auto z : { Complex (-1e-6, 1e-4), Complex (-0.01, 1), Complex (-0.05, 4.5), Complex (-0.5, 15) })
    {
        const auto pole = z / length, step = Complex (1e-4 / length, 0);
        const auto difference =
            (added (forceTaps (pole + step, length).taps) - added (forceTaps (pole - step, length).taps))
            / (2.0 * step);
        CAPTURE (z);
        CHECK (std::abs (added (forceTaps (pole, length).byPole) - difference) < 1e-7 * length * length);
    }
}
