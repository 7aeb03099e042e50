#include "TilePhasors.h"

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
using Long = std::complex<long double>;

Long longExponential (const Oscillation& oscillation, long double time)
{
    const auto size = std::exp (oscillation.growth * time);
    const auto phase = oscillation.angularFrequency * time;
    return { size * std::cos (phase), size * std::sin (phase) };
}

/** e^{p n step} for n below a power of 4: products of two exact ones, rounded from extended precision, which is as good
   as exact and takes a tenth of the time of exponentials. */
template <typename Take>
void eachPower (const Oscillation& oscillation, long double step, int count, const Take& take)
{
    const auto fineCount = static_cast<int> (std::lround (std::sqrt (count)));
    std::array<Long, 16> fine;

    for (int n = 0; n < fineCount; ++n)
        fine[static_cast<std::size_t> (n)] = longExponential (oscillation, n * step);

    for (int coarse = 0; coarse < count; coarse += fineCount)
    {
        const auto from = longExponential (oscillation, coarse * step);

        for (int n = 0; n < fineCount; ++n)
        {
            const auto& turn = fine[static_cast<std::size_t> (n)];
            const auto real = from.real() * turn.real() - from.imag() * turn.imag();
            const auto imaginary = from.real() * turn.imag() + from.imag() * turn.real();
            take (coarse + n, std::complex<double> (static_cast<double> (real), static_cast<double> (imaginary)));
        }
    }
}
} // namespace

std::complex<double> exponential (const Oscillation& oscillation, long double time)
{
    const auto value = longExponential (oscillation, time);
    return { static_cast<double> (value.real()), static_cast<double> (value.imag()) };
}

TilePhasors::TilePhasors (const Oscillation& oscillation, std::complex<double> firstPhasor, double rate,
                          std::int64_t strips)
    : first (firstPhasor)
{
    // Entries beyond the oscillation's end may be infinite, but are unused.
    const auto tileTime = [&] (std::int64_t tile) { return static_cast<long double> (tile * synthesisTile) / rate; };
    turnsOfGroup.resize (2UL * synthesisGroup * synthesisStrip);
    const auto takeTurn = [this] (int tile, std::complex<double> turn)
    {
        auto* const strip =
            turnsOfGroup.data() + static_cast<std::ptrdiff_t> (tile / synthesisStrip) * 2 * synthesisStrip;
        strip[tile % synthesisStrip] = turn.real();
        strip[tile % synthesisStrip + synthesisStrip] = turn.imag();
    };
    eachPower (oscillation, tileTime (1), synthesisGroup * synthesisStrip, takeTurn);

    for (std::int64_t step = synthesisGroup; step < strips; step *= digitBase)
        eachPower (oscillation, tileTime (step * synthesisStrip), digitBase,
                   [this] (int, std::complex<double> power) { powers.push_back (power); });
}
} // namespace antinode
