#include "TilePhasors.h"

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int base = 64;
using Long = std::complex<long double>;

Long longExponential (const Oscillation& oscillation, long double time)
{
    const auto size = std::exp (oscillation.growth * time);
    const auto phase = oscillation.angularFrequency * time;
    return { size * std::cos (phase), size * std::sin (phase) };
}

/** e^{p n step} for n below a power of 4: products of two exact ones, rounded from extended precision, which is as good as exact and takes
    a tenth of the time of exponentials. */
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
                          std::int64_t tiles)
    : first (firstPhasor), turns (2UL * (synthesisGroup + synthesisStrip), 0.0)
{
    // Entries beyond the oscillation's end may be infinite; nobody uses them.
    const auto timeOf = [&] (std::int64_t tile) { return static_cast<long double> (tile * synthesisTile) / rate; };
    const auto takeTurn = [this] (int at, std::complex<double> turn)
    {
        const auto tile = static_cast<std::size_t> (at);
        turns[tile] = turn.real();
        turns[tile + synthesisGroup + synthesisStrip] = turn.imag();
    };
    eachPower (oscillation, timeOf (1), synthesisGroup, takeTurn);

    for (std::int64_t step = synthesisGroup; step < tiles; step *= base)
        eachPower (oscillation, timeOf (step), base,
                   [this] (int, std::complex<double> power) { powers.push_back (power); });
}

std::complex<double> TilePhasors::atGroup (std::uint64_t group) const
{
    auto phasor = first;

    for (const auto* level = powers.data(); group > 0; level += base, group /= base)
        if (const auto digit = group % base; digit > 0)
            phasor = product (phasor, level[digit]);

    return phasor;
}
} // namespace antinode
