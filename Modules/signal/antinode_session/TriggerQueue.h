#pragma once

#include "StopCount.h"

#include <antinode_base/RingQueue.h>
#include <antinode_engine/FocusEvent.h>

#include <cstdint>
#include <mutex>
#include <span>

namespace antinode
{
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
} // namespace antinode
