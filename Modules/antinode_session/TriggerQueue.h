#pragma once

#include <antinode_engine/FocusEvent.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <span>

namespace antinode
{
/** Triggers on their way to the audio thread that did not come with a block: a button, a touch, a message. The audio thread neither
    locks nor waits; pushes are serialised. */
class TriggerQueue
{
public:
    /** @return  false where 256 wait already: then this one is dropped. [any but the audio thread] */
    bool push (const FocusEvent&);

    /** Takes the oldest ones. @return  how many were taken [audio thread] */
    int pop (std::span<FocusEvent> events);

private:
    static constexpr std::size_t capacity = 256;

    std::mutex pushing;
    std::array<FocusEvent, capacity> ring {};
    std::atomic<std::size_t> written { 0 }, read { 0 };
};
} // namespace antinode
