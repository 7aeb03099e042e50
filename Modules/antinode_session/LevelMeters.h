#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace antinode
{
/** Meters of the audio thread for other threads: peaks since the last read, and counters. */
class LevelMeters
{
public:
    static constexpr int ceramics = 64;
    static constexpr int probes = 8;

    /** [audio thread] @param volts  the largest magnitude in a block */
    void notePeak (int ceramic, float volts) { raise (peaks, ceramic, volts); }
    void noteProbe (int probe, float metresPerSecond) { raise (probePeaks, probe, metresPerSecond); }
    void noteLimited (int ceramic, std::int64_t samples) { limited[static_cast<std::size_t> (ceramic)] = samples; }
    void noteState (bool isMutedForBadNumbers, int voices, std::int64_t triggered)
    {
        badNumbers = isMutedForBadNumbers;
        activeVoices = voices;
        triggers = triggered;
    }

    /** The largest voltage since the last call, V. One reader. [any] */
    float takePeak (int ceramic) { return peaks[static_cast<std::size_t> (ceramic)].exchange (0); }

    /** The largest velocity since the last call, m/s. One reader. [any] */
    float takeProbe (int probe) { return probePeaks[static_cast<std::size_t> (probe)].exchange (0); }

    /** The number of samples clamped by the limiter since the path was made. [any] */
    std::int64_t limitedSamples (int ceramic) const { return limited[static_cast<std::size_t> (ceramic)]; }

    /** Whether a number that was not finite has muted the output. [any] */
    bool isMutedForBadNumbers() const { return badNumbers; }

    int voices() const { return activeVoices; }
    std::int64_t triggered() const { return triggers; }

private:
    template <std::size_t count>
    static void raise (std::array<std::atomic<float>, count>& values, int index, float value)
    {
        auto& present = values[static_cast<std::size_t> (index)];

        // One writer: what a reader resets in between only makes a peak last a block longer.
        if (value > present.load (std::memory_order_relaxed))
            present.store (value, std::memory_order_relaxed);
    }

    std::array<std::atomic<float>, ceramics> peaks {};
    std::array<std::atomic<float>, probes> probePeaks {};
    std::array<std::atomic<std::int64_t>, ceramics> limited {};
    std::atomic<bool> badNumbers { false };
    std::atomic<int> activeVoices { 0 };
    std::atomic<std::int64_t> triggers { 0 };
};
} // namespace antinode
