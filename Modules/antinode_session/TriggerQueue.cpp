#include "TriggerQueue.h"

#include <algorithm>

namespace antinode
{
bool TriggerQueue::push (const FocusEvent& event)
{
    const std::lock_guard lock (pushing);
    return waiting.push (event);
}

int TriggerQueue::pop (std::span<FocusEvent> events)
{
    std::size_t count = 0;

    for (auto left = std::min (waiting.size(), events.size()); left > 0; --left)
        events[count++] = waiting.pop().value();

    return static_cast<int> (count);
}
} // namespace antinode
