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
        modes.push_back (modeOf (oscillation));
    }

    // The focus is on a sample, the brakes keep their distance to it; a sample within 1e-6 of a step belongs to it.
    const auto position = [&] (double time)
    { return static_cast<double> (synthesiser.focusSample()) + (time - brakes.focusTime) * rate; };
    start = static_cast<std::int64_t> (std::ceil (position (first) - 1e-6));
    end = static_cast<std::int64_t> (std::ceil (position (last))) + 1;
    longest = static_cast<std::int64_t> (std::min (-std::log (nothingLeft) / slowest * rate, longestSamples));
}

PlayableBrake::Mode PlayableBrake::modeOf (const Oscillation& brake)
{
    const auto excess = brake.growth + brake.freeDecay; // p - s = (1 - gamma') a
    const auto mismatch = -excess / brake.angularFrequency;
    const std::complex<double> j (0, 1);
    const auto moved = j * brake.phasor() / (excess + 2.0 * j * brake.angularFrequency);
    const auto size = std::abs (moved);
    const auto direction = size > 0 ? moved / size : std::complex<double> (1); // no force: any factor will do
    return { brake.freeDecay, brake.angularFrequency, mismatch, direction - mismatch * direction.imag(),
             std::conj (direction) };
}

void PlayableBrake::factorsAfter (std::int64_t delay, std::span<std::complex<double>> factors) const
{
    const auto time = static_cast<double> (delay) / rate;

    for (std::size_t c = 0; c < modes.size(); ++c)
    {
        const auto& mode = modes[c];
        const auto left = std::exp (-mode.decay * time);
        const auto size = left > still ? left : 0.0;
        const auto phase = mode.frequency * time;
        const auto state = product (mode.state, { size * std::cos (phase), size * std::sin (phase) });
        factors[c] = product (state + mode.mismatch * state.imag(), mode.turnBack);
    }
}
} // namespace antinode
