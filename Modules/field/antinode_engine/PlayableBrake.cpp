#include "PlayableBrake.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double nothingLeft = 1e-3; // of the slowest mode's amplitude
constexpr double still = 1e-6;       // of a mode's amplitude: brakes end there, and less would come to denormal numbers
constexpr double longestSamples = 1e12; // however slowly a mode decays: sums of such numbers are exact
} // namespace

PlayableBrake::PlayableBrake (const VoltageProgram& brakes, Playback playback)
    : synthesiser (brakes, playback), rate (playback.sampleRate)
{
    auto first = brakes.oscillations.front().start, last = brakes.oscillations.front().end;
    auto slowest = brakes.oscillations.front().freeDecay;

    for (const auto& oscillation : brakes.oscillations)
    {
        first = std::min (first, oscillation.start);
        last = std::max (last, oscillation.end);
        slowest = std::min (slowest, oscillation.freeDecay);
        modes.push_back (toMode (oscillation));
    }

    // The focus is on a sample, the brakes keep their distance to it; a sample within 1e-6 of a step belongs to it.
    const auto position = [&] (double time)
    { return static_cast<double> (synthesiser.focusSample()) + (time - brakes.focusTime) * rate; };
    start = static_cast<std::int64_t> (std::ceil (position (first) - 1e-6));
    end = static_cast<std::int64_t> (std::ceil (position (last))) + 1;
    longest = static_cast<std::int64_t> (std::min (-std::log (nothingLeft) / slowest * rate, longestSamples));
}

PlayableBrake::Mode PlayableBrake::toMode (const Oscillation& brake)
{
    const auto rho = brake.counterShare;
    const auto scale = 1 / (1 - std::norm (rho));
    return { brake.freeDecay, brake.angularFrequency, scale * (1.0 + rho),
             scale * product (rho, 1.0 + std::conj (rho)) };
}

void PlayableBrake::factorsAfter (std::int64_t delay, std::span<std::complex<double>> factors) const
{
    const auto time = static_cast<double> (delay) / rate;

    for (std::size_t c = 0; c < modes.size(); ++c)
    {
        const auto& mode = modes[c];

        // The parts of a mode's brake follow one another.
        if (c > 0 && mode.isAs (modes[c - 1]))
        {
            factors[c] = factors[c - 1];
            continue;
        }

        const auto left = std::exp (-mode.decay * time);
        const auto size = left > still ? left : 0.0;
        const auto phase = mode.frequency * time;
        const std::complex<double> turn { size * std::cos (phase), size * std::sin (phase) };
        factors[c] = product (mode.with, turn) - product (mode.against, std::conj (turn));
    }
}
} // namespace antinode
