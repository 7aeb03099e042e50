#pragma once

#include "AudioPath.h"
#include "PathExchange.h"
#include "TriggerQueue.h"

#include <antinode_engine/EventDelay.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** Where the audio thread enters a session: triggers in, the path that plays, meters out. The session's thread gives it
   paths, by one atomic exchange. */
class AudioEntry
{
public:
    /** Plays a block, or silence while there is no path. [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, const PlayControls&);

    /** The sample rate from the next block on; what plays comes to rest. Nothing may be processing. [worker] */
    void prepare (double sampleRate);

    /** Fires a place of the bank with the next block, unless there was a stop since it was asked for.
        @param amplitude  0 to 1 @param askedAt  number of the stop before it [any but the audio thread] */
    void fire (int place, double amplitude, std::uint64_t askedAt)
    {
        triggers.push ({ 0, FocusEventKind::trigger, place, amplitude }, askedAt);
    }

    /** Fades all voices out with the next block, and voids what was asked for before: a stop by a button, by a message,
        by all notes off among the events of a block, and by prepare(). [any] */
    StopCount& stops() { return stopCount; }

    /** The place of the bank that an event means. [any] */
    int eventPlace (const FocusEvent&) const;

    /** Whether every note plays the focus at its own place. [any] */
    void setPlaysSpotOnly (bool should) { playsSpotOnly = should; }

    /** [session's thread] PathExchange */
    void give (std::unique_ptr<AudioPath> path) { paths.give (std::move (path)); }
    void collect() { paths.collect(); }

    /** Frees all paths, at the end. Nothing may be processing. [session's thread] */
    void clear() { paths.clear(); }

    LevelMeters& meters() { return levels; }
    ProbeTrace& probeTrace() { return trace; }

    /** The voltage of a sample of 1.0 in the last block, V; 0 before the first block. [any] */
    double fullScaleVolts() const { return fullScale; }

private:
    std::span<const FocusEvent> gather (std::span<const FocusEvent> events);

    static constexpr std::size_t mostOfBlock = 1024; ///< Events that come with one.

    std::atomic<bool> playsSpotOnly { false };
    std::atomic<double> preparedRate { 0 }, fullScale { 0 };
    StopCount stopCount;
    TriggerQueue triggers { stopCount };
    EventDelay held;              ///< Of the audio thread: events that wait while the path ramps out for another one.
    std::uint64_t playedStop = 0; ///< The newest one, of the audio thread as the next line.
    std::array<FocusEvent, 1 + TriggerQueue::capacity + mostOfBlock> blockEvents {};
    LevelMeters levels;
    ProbeTrace trace;
    PathExchange<AudioPath> paths;
};
} // namespace antinode
