#include "TilePhasors.h"

#include <cmath>

namespace antinode
{
namespace
{
constexpr std::int64_t base = synthesisGroup;
} // namespace

std::complex<double> exponential (const Oscillation& oscillation, long double time)
{
    const auto size = std::exp (oscillation.growth * time);
    const auto phase = oscillation.angularFrequency * time;
    return { static_cast<double> (size * std::cos (phase)), static_cast<double> (size * std::sin (phase)) };
}

TilePhasors::TilePhasors (const Oscillation& oscillation, std::complex<double> firstPhasor, double rate,
                          std::int64_t tiles)
    : first (firstPhasor)
{
    // Entries beyond the oscillation's end may be infinite; nobody asks for them.
    std::int64_t step = 1;

    do
    {
        for (std::int64_t digit = 0; digit < base; ++digit)
            powers.push_back (
                exponential (oscillation, static_cast<long double> (digit * step * synthesisTile) / rate));

        step *= base;
    } while (step < tiles);
}

std::complex<double> TilePhasors::atGroup (std::int64_t group) const
{
    auto phasor = first;

    for (std::size_t level = 1; group > 0; ++level, group /= base)
        if (const auto digit = static_cast<std::size_t> (group % base); digit > 0)
            phasor = product (phasor, powers[level * base + digit]);

    return phasor;
}
} // namespace antinode
