#pragma once

#include <antinode_base/RingQueue.h>
#include <antinode_engine/FocusEvent.h>

#include <mutex>
#include <span>

namespace antinode
{
/** Triggers on their way to the audio thread that did not come with a block: a button, a touch, a message. The audio
   thread neither locks nor waits; pushes are serialised. */
class TriggerQueue
{
public:
    /** @return  false where 256 wait already: then this one is dropped. [any but the audio thread] */
    bool push (const FocusEvent&);

    /** Takes the oldest ones. @return  how many were taken [audio thread] */
    int pop (std::span<FocusEvent> events);

private:
    std::mutex pushing;
    RingQueue<FocusEvent, 256> waiting;
};
} // namespace antinode
