#include "TilePhasors.h"

#include <array>
#include <cmath>

namespace antinode
{
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

    for (std::int64_t step = synthesisGroup; step < strips; step *= digitBase)
        for (int digit = 0; digit < static_cast<int> (digitBase); ++digit)
            powers.push_back (power (digit * step * synthesisStrip));
}
} // namespace antinode
