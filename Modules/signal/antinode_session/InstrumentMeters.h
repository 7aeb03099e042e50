#pragma once

#include "PlayControls.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace antinode
{
/** The largest of each of some numbers since the last read: one thread writes, another one reads. */
template <std::size_t count>
class PeakMeters
{
public:
    /** [audio thread] @param value  at least 0 */
    void note (int index, float value)
    {
        auto& present = values[static_cast<std::size_t> (index)];

        // One writer: what a reader resets in between only makes a peak last a block longer.
        if (value > present.load (std::memory_order_relaxed))
            present.store (value, std::memory_order_relaxed);
    }

    /** [any] One reader. */
    float take (int index) { return values[static_cast<std::size_t> (index)].exchange (0); }

private:
    std::array<std::atomic<float>, count> values {};
};

/** The newest of some numbers that one thread writes, for others to draw: while it writes, the oldest of what is read
   may be newer than it seems. */
class FingerTrace
{
public:
    static constexpr std::size_t length = 1024;

    /** [audio thread] one writer */
    void push (float value)
    {
        const auto count = written.load (std::memory_order_relaxed);
        values[count % length].store (value, std::memory_order_relaxed);
        written.store (count + 1, std::memory_order_release);
    }

    /** The newest ones, the oldest of them first; 0 in place of those that were never written. @param count  at most
        `length` [any but the audio thread] */
    std::vector<float> newest (std::size_t count) const
    {
        std::vector<float> read;
        const auto end = written.load (std::memory_order_acquire) + length;

        for (auto i = end - count; i < end; ++i)
            read.push_back (values[i % length].load (std::memory_order_relaxed));

        return read;
    }

    /** How many were written so far. [any] */
    std::uint64_t count() const { return written; }

private:
    std::array<std::atomic<float>, length> values {};
    std::atomic<std::uint64_t> written { 0 };
};

/** Levels of the audio thread for other threads. */
struct FingerMeters
{
    PeakMeters<mostFingers> inputs;              ///< Of full scale.
    PeakMeters<mostFingers> displacements;       ///< m within the band: what is asked for.
    PeakMeters<mostFingers> felt;                ///< Times the threshold of skin.
    std::array<FingerTrace, mostFingers> traces; ///< m within the band, sample by sample of the filters.
    std::atomic<double> traceRate { 0 };         ///< Hz, of the traces; 0 before anything plays.
};

/** Meters of the audio thread for other threads: peaks since the last read, and counters, which go on from path to
 * path.
 */
class LevelMeters
{
public:
    static constexpr int ceramics = 64;
    static constexpr int probes = 8;

    /** [audio thread] @param volts  the largest magnitude in a block */
    void notePeak (int ceramic, float volts)
    {
        peaks.note (ceramic, volts);
        blockPeak = std::max (blockPeak, volts);
    }
    void noteProbe (int probe, float metresPerSecond) { probePeaks.note (probe, metresPerSecond); }
    void addLimited (int ceramic, std::int64_t samples)
    {
        if (samples > 0)
        {
            limited[static_cast<std::size_t> (ceramic)] += samples;
            allLimited += samples;
        }
    }
    void addTriggered (std::int64_t voices) { triggers += voices; }
    void noteState (bool isMutedForBadNumbers, int voices)
    {
        badNumbers = isMutedForBadNumbers;
        activeVoices = voices;
    }

    /** The largest voltage of all ceramics since the last call, V, and all samples that limiters have clamped.
        [audio thread] */
    float takeBlockPeak() { return std::exchange (blockPeak, 0.0F); }
    std::int64_t allLimitedSamples() const { return allLimited; }

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
    float blockPeak = 0; ///< Of the audio thread, as the next line.
    std::int64_t allLimited = 0;
};

/** The last second or so of the first probe's velocity, to be drawn: each entry is the largest and the least value of
    some samples. */
class ProbeTrace
{
public:
    static constexpr std::size_t capacity = 4096;

    struct Entry
    {
        float smallest = 0, largest = 0; ///< m/s
    };

    /** @param samples  how many make an entry, 1 or more; the one that is begun may be of either length [any] */
    void prepare (int samples) { samplesPerEntry.store (samples, std::memory_order_relaxed); }

    /** [audio thread] */
    void write (const double* velocities, int count);

    /** The newest entries, oldest first; torn ones are possible and last one frame. [any] */
    std::vector<Entry> newest (std::size_t count) const;

    /** The number of entries written so far. [any] */
    std::uint64_t written() const { return position.load (std::memory_order_acquire); }

private:
    std::atomic<int> samplesPerEntry { 48 };
    int inEntry = 0; ///< Of the audio thread, as the next line.
    Entry current;
    std::array<std::atomic<float>, capacity> smallest {}, largest {};
    std::atomic<std::uint64_t> position { 0 };
};

/** What the audio thread tells of an instrument; goes on from path to path. */
struct InstrumentMeters
{
    LevelMeters levels;
    ProbeTrace trace; ///< Of the first probe of the monitor.
    FingerMeters fingers;
};
} // namespace antinode
