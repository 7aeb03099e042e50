#pragma once

#include "DevicePath.h"
#include "InstrumentPath.h"
#include "PlayReports.h"

#include <antinode_base/LockFreeExchange.h>
#include <antinode_engine/FocusEvents.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

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

    /** A trigger. */
    struct Fired
    {
        FocusEvent event;
        std::uint64_t askedAt = 0; ///< StopCount::now() of when it was asked for.
        std::int64_t due = 0;      ///< The sample of the session's clock that it is for; one that is over: at once.
    };

    /** @return  false where `capacity` wait already: then this one is dropped. [any but the audio thread] */
    bool push (const Fired&);

    /** Takes all that wait, the oldest first, with those that a stop has made void.
        @param fired  room for `capacity`
        @return       how many, and the newest stop, which the audio thread is to play first [audio thread] */
    std::pair<std::size_t, std::uint64_t> pop (std::span<Fired> fired);

private:
    const StopCount& stops;
    std::mutex pushing;
    RingQueue<Fired, capacity> waiting;
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
        @param amplitude  0 to 1 @param askedAt  number of the stop before it
        @param request    of whom reports() tell; 0: nobody asks
        @param due        the sample of clock() that it is for, from now on mostScheduled at once; 0: the next block
        @return           false where too many wait [any but the audio thread] */
    bool fire (int place, double amplitude, std::uint64_t askedAt, std::uint32_t request = 0, std::int64_t due = 0)
    {
        return triggers.push ({ { 0, FocusEventKind::trigger, place, amplitude, request }, askedAt, due });
    }

    /** What becomes of triggers with a request. */
    PlayReports& reports() { return playReports; }

    /** When samples are played, counted from the session's begin. */
    const SampleClock& clock() const { return sampleClock; }

    /** The marker of the block that was played last, as long as it. @param width  samples [audio thread] */
    void writeMarker (float* to, int count, std::int64_t width)
    {
        playReports.writeMarker (to, count, position - count, width);
    }

    /** Fades all voices out with the next block, and voids what was asked for before: a stop by a button, by a message,
        by all notes off among the events of a block, and by prepare(). [any] */
    StopCount& stops() { return stopCount; }

    /** What notes play from the next block on. @param level  of noteAmplitude() [session's thread] */
    void setNotes (NoteMeaning notes, double level)
    {
        meaning = notes;
        noteLevel = level;
    }
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
    static constexpr std::size_t mostScheduled = 1024;

    std::span<const FocusEvent> gather (std::span<const FocusEvent> events, int count, double focusGain);
    std::size_t takeFired (std::span<FocusEvent> events, int count);
    template <typename Sample>
    void playSilence (const AudioBlock<Sample>&);

    std::atomic<NoteMeaning> meaning { NoteMeaning::nothing };
    std::atomic<double> noteLevel { 0 }; ///< dB SL
    std::atomic<double> preparedRate { 0 }, fullScale { 0 };
    StopCount stopCount;
    TriggerQueue triggers { stopCount };
    EventDelay waiting; ///< Of the audio thread: notes until filters give what comes with them, and all events while
                        ///< the path ramps out for another one. It lasts longer than a path.
    std::uint64_t playedStop = 0; ///< The newest one, of the audio thread as the next line.
    std::array<TriggerQueue::Fired, mostScheduled> scheduled {}; ///< That are due later.
    std::size_t scheduledCount = 0;
    bool wasArmed = false;
    std::array<TriggerQueue::Fired, TriggerQueue::capacity> fired {};
    std::array<FocusEvent, 1 + mostScheduled + TriggerQueue::capacity + EventDelay::mostPerBlock> blockEvents {};
    std::int64_t position = 0; ///< Of the session's clock.
    PlayReports playReports;
    SampleClock sampleClock;
    PathExchange<InstrumentPath> paths;
};
} // namespace antinode
