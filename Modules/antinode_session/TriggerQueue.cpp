#include "TriggerQueue.h"

namespace antinode
{
bool TriggerQueue::push (const FocusEvent& event)
{
    const std::lock_guard lock (pushing);
    const auto position = written.load (std::memory_order_relaxed);

    if (position - read.load (std::memory_order_acquire) >= capacity)
        return false;

    ring[position % capacity] = event;
    written.store (position + 1, std::memory_order_release);
    return true;
}

int TriggerQueue::pop (std::span<FocusEvent> events)
{
    const auto end = written.load (std::memory_order_acquire);
    auto position = read.load (std::memory_order_relaxed);
    int count = 0;

    for (; position != end && count < static_cast<int> (events.size()); ++position)
        events[static_cast<std::size_t> (count++)] = ring[position % capacity];

    read.store (position, std::memory_order_release);
    return count;
}
} // namespace antinode
