#pragma once

#include "InstrumentMeters.h"

#include <antinode_base/LockFreeExchange.h>
#include <antinode_engine/FocusPlayer.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace antinode
{
/** What became of a trigger that somebody waits for. Samples are those of the session's clock, which counts all that it
    has played. */
struct PlayReport
{
    enum class Kind
    {
        begun,
        empty,    ///< Its place has no focus: nothing plays.
        finished, ///< It has played to its end.
        stopped   ///< It was stopped, or came after a stop.
    };

    Kind kind = Kind::begun;
    std::uint32_t request = 0;
    std::int64_t onset = 0;          ///< The first sample that sounds.
    std::int64_t focus = 0;          ///< The sample on which the focus falls.
    float peakVolts = 0;             ///< Of all ceramics while it played, with what else played.
    std::int64_t limitedSamples = 0; ///< In that time.
};

/** Follows triggers from their first to their last sample, and keeps when foci fall for a marker. */
class PlayReports
{
public:
    /** What began in a block. @param voices  in the player's samples @param offset  from these to the session's
        @param limitedBefore  samples that limiters had clamped before the block [audio thread] */
    void begin (std::span<const BegunVoice> voices, std::int64_t offset, std::int64_t limitedBefore,
                const LevelMeters&);

    /** Behind a block. @param end  its end @param peakVolts  of it [audio thread] */
    void endBlock (std::int64_t end, float peakVolts, const LevelMeters&);

    /** All that plays fades out. [audio thread] */
    void stop (const LevelMeters&);

    /** A trigger that is void before it has begun. [audio thread] */
    void cancel (const FocusEvent& event) { push ({ PlayReport::Kind::stopped, event.request }); }

    /** The oldest that was not taken. One reader. [any] */
    std::optional<PlayReport> take() { return reports.pop(); }

    /** Those that nobody has taken in time. [any] */
    std::int64_t lost() const { return lostCount; }

    /** Writes the marker of a block that was played: 1 from each focus on for some samples, else 0.
        @param begin  the first sample of the block [audio thread] */
    void writeMarker (float* to, int count, std::int64_t begin, std::int64_t width);

private:
    static constexpr std::size_t mostMarks = 256;

    struct Playing
    {
        PlayReport report;
        std::int64_t end = 0, limitedBefore = 0;
    };

    void push (const PlayReport&);
    void finish (std::size_t index, PlayReport::Kind, const LevelMeters&);
    void finishUntil (std::int64_t end, const LevelMeters&);

    std::array<Playing, FocusVoices::soundingVoices> playing {}; ///< In the order in which they began.
    std::size_t count = 0;
    std::array<std::int64_t, mostMarks> marks {}; ///< Samples of foci, unsorted.
    std::size_t markCount = 0;
    RingQueue<PlayReport, 8192> reports;
    std::atomic<std::int64_t> lostCount { 0 };
};

/** When samples of the session are played: a delay-locked loop on the times of its blocks, which jitter (Adriaensen,
    "Using a DLL to filter time", 2005). */
class SampleClock
{
public:
    using Time = std::chrono::steady_clock::time_point;

    /** A block begins. @param sample  its first one [audio thread] */
    void begin (std::int64_t sample, int count, double sampleRate, Time now);

    /** When a sample is handed to the device; none before the first block. [any] */
    std::optional<Time> timeOf (std::int64_t sample) const;

    /** The sample that is handed over then; none before the first block. [any] */
    std::optional<std::int64_t> sampleAt (Time) const;

private:
    struct Line
    {
        std::int64_t sample = 0;
        double seconds = 0, period = 0; ///< s since the clock's epoch at `sample`; s a sample.
    };

    std::optional<Line> line() const;

    Line now;                   ///< Of the audio thread, as the next lines.
    double rate = 0, begun = 0; ///< Hz; s, of the first block since the loop began.
    std::int64_t next = -1;
    double lastCall = 0, lastLength = 0;      ///< s: when the last part came, and how long it was.
    std::atomic<std::uint64_t> version { 0 }; ///< Odd while the next lines are written; 0: nothing was.
    std::atomic<std::int64_t> sample { 0 };
    std::atomic<double> seconds { 0 }, period { 0 };
};
} // namespace antinode
