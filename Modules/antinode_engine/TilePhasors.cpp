#include "TilePhasors.h"

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int base = 64;
} // namespace

std::complex<double> exponential (const Oscillation& oscillation, long double time)
{
    const auto size = std::exp (oscillation.growth * time);
    const auto phase = oscillation.angularFrequency * time;
    return { static_cast<double> (size * std::cos (phase)), static_cast<double> (size * std::sin (phase)) };
}

TilePhasors::TilePhasors (const Oscillation& oscillation, std::complex<double> firstPhasor, double rate,
                          std::int64_t strips)
    : first (firstPhasor)
{
    // Entries beyond the oscillation's end may be infinite; nobody uses them.
    const auto power = [&] (std::int64_t tile)
    { return exponential (oscillation, static_cast<long double> (tile * synthesisTile) / rate); };

    for (std::int64_t strip = 0; strip < synthesisGroup; ++strip)
    {
        std::array<std::complex<double>, synthesisStrip> turns;

        for (std::size_t t = 0; t < turns.size(); ++t)
            turns[t] = power (strip * synthesisStrip + static_cast<std::int64_t> (t));

        for (const auto& turn : turns)
            turnsOfGroup.push_back (turn.real());

        for (const auto& turn : turns)
            turnsOfGroup.push_back (turn.imag());
    }

    for (std::int64_t step = synthesisGroup; step < strips; step *= base)
        for (int digit = 0; digit < base; ++digit)
            powers.push_back (power (digit * step * synthesisStrip));
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
