#pragma once

#include "PeakMeters.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace antinode
{
/** Meters of the audio thread for other threads: peaks since the last read, and counters, which go on from path to
 * path.
 */
class LevelMeters
{
public:
    static constexpr int ceramics = 64;
    static constexpr int probes = 8;

    /** [audio thread] @param volts  the largest magnitude in a block */
    void notePeak (int ceramic, float volts) { peaks.note (ceramic, volts); }
    void noteProbe (int probe, float metresPerSecond) { probePeaks.note (probe, metresPerSecond); }
    void addLimited (int ceramic, std::int64_t samples)
    {
        if (samples > 0)
            limited[static_cast<std::size_t> (ceramic)] += samples;
    }
    void addTriggered (std::int64_t voices) { triggers += voices; }
    void noteState (bool isMutedForBadNumbers, int voices)
    {
        badNumbers = isMutedForBadNumbers;
        activeVoices = voices;
    }

    /** The largest voltage since the last call, V. One reader. [any] */
    float takePeak (int ceramic) { return peaks.take (ceramic); }

    /** The largest velocity since the last call, m/s. One reader. [any] */
    float takeProbe (int probe) { return probePeaks.take (probe); }

    /** The number of samples clamped by limiters. [any] */
    std::int64_t limitedSamples (int ceramic) const { return limited[static_cast<std::size_t> (ceramic)]; }

    /** Whether a number that was not finite has muted the output. [any] */
    bool isMutedForBadNumbers() const { return badNumbers; }

    /** Foci that play now, and all that began. [any] */
    int voices() const { return activeVoices; }
    std::int64_t triggered() const { return triggers; }

private:
    PeakMeters<ceramics> peaks;
    PeakMeters<probes> probePeaks;
    std::array<std::atomic<std::int64_t>, ceramics> limited {};
    std::atomic<bool> badNumbers { false };
    std::atomic<int> activeVoices { 0 };
    std::atomic<std::int64_t> triggers { 0 };
};
} // namespace antinode
