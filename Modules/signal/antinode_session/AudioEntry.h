#pragma once

#include "DevicePath.h"
#include "InstrumentPath.h"

#include <antinode_base/LockFreeExchange.h>
#include <antinode_engine/FocusEvents.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>

namespace antinode
{
/** The order between stops and all else that threads ask for: how often everything was stopped. What is asked for keeps
    the number of its time wherever it waits, and is void once there is a newer one. [any] */
class StopCount
{
public:
    std::uint64_t now() const { return stops; }

    /** Of those by stop(): what plays by itself, as the notes of a file do, ends with them, not with notes that stop.
     */
    std::uint64_t commands() const { return commanded; }

    /** A command of a person or a host. */
    void stop()
    {
        ++commanded;
        ++stops;
    }

    /** All notes off. @return  the number from now on */
    std::uint64_t stopByNote() { return ++stops; }

private:
    std::atomic<std::uint64_t> stops { 0 }, commanded { 0 };
    static_assert (std::atomic<std::uint64_t>::is_always_lock_free);
};

/** Triggers on their way to the audio thread that did not come with a block: a button, a touch, a message. The audio
   thread neither locks nor waits; pushes are serialised. */
class TriggerQueue
{
public:
    static constexpr std::size_t capacity = 256;

    /** @param stopsToCount  outlive this */
    explicit TriggerQueue (const StopCount& stopsToCount) : stops (stopsToCount) {}

    /** @param askedAt  StopCount::now() of when it was asked for
        @return         false where `capacity` wait already: then this one is dropped. [any but the audio thread] */
    bool push (const FocusEvent&, std::uint64_t askedAt);

    /** What was taken: those that were asked for since the newest stop, which the audio thread is to play first. */
    struct Taken
    {
        std::size_t count = 0;
        std::uint64_t stop = 0;
    };

    /** Takes all that wait, the oldest first. @param events  room for `capacity` [audio thread] */
    Taken pop (std::span<FocusEvent> events);

private:
    struct Waiting
    {
        FocusEvent event;
        std::uint64_t askedAt = 0;
    };

    const StopCount& stops;
    std::mutex pushing;
    RingQueue<Waiting, capacity> waiting;
};

/** Where the audio thread enters a session, which derives from it: notes and triggers in, the path that plays, meters
    out. The session's thread gives it paths, by one atomic exchange. */
class AudioEntry
{
public:
    /** Plays a block, or silence while there is no path. [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, const PlayControls&);

    /** The sample rate from the next block on; what plays comes to rest. Nothing may be processing. [worker] */
    void prepare (double sampleRate);

    /** Hz; 0 before the first preparation. [any] */
    double sampleRate() const { return preparedRate; }

    /** Fires a place of the bank with the next block, unless there was a stop since it was asked for.
        @param amplitude  0 to 1 @param askedAt  number of the stop before it [any but the audio thread] */
    void fire (int place, double amplitude, std::uint64_t askedAt)
    {
        triggers.push ({ 0, FocusEventKind::trigger, place, amplitude }, askedAt);
    }

    /** Fades all voices out with the next block, and voids what was asked for before: a stop by a button, by a message,
        by all notes off among the events of a block, and by prepare(). [any] */
    StopCount& stops() { return stopCount; }

    /** What notes play from the next block on. [session's thread] */
    void setNotes (NoteMeaning notes) { meaning = notes; }
    NoteMeaning notes() const { return meaning; }

    /** [session's thread] PathExchange */
    void give (std::unique_ptr<InstrumentPath> path) { paths.give (std::move (path)); }
    void collect() { paths.collect(); }

    /** Frees all paths, at the end. Nothing may be processing. [session's thread] */
    void clear() { paths.clear(); }

    /** The voltage of a sample of 1.0 in the last block, V; 0 before the first block. [any] */
    double fullScaleVolts() const { return fullScale; }

protected:
    ~AudioEntry() = default;

    InstrumentMeters played; ///< Of what plays.

private:
    std::span<const FocusEvent> gather (std::span<const FocusEvent> events, double focusGain);

    std::atomic<NoteMeaning> meaning { NoteMeaning::nothing };
    std::atomic<double> preparedRate { 0 }, fullScale { 0 };
    StopCount stopCount;
    TriggerQueue triggers { stopCount };
    EventDelay waiting; ///< Of the audio thread: notes until filters give what comes with them, and all events while
                        ///< the path ramps out for another one. It lasts longer than a path.
    std::uint64_t playedStop = 0; ///< The newest one, of the audio thread as the next line.
    std::array<FocusEvent, 1 + TriggerQueue::capacity + EventDelay::mostPerBlock> blockEvents {};
    PathExchange<InstrumentPath> paths;
};
} // namespace antinode
