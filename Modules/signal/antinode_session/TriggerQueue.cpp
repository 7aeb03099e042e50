#include "TriggerQueue.h"

#include <algorithm>

namespace antinode
{
bool TriggerQueue::push (const FocusEvent& event, std::uint64_t askedAt)
{
    const std::lock_guard lock (pushing);
    return waiting.push ({ event, askedAt });
}

TriggerQueue::Taken TriggerQueue::pop (std::span<FocusEvent> events)
{
    // First how many, then the stop: so none of them was asked for after a stop that is not seen yet.
    auto left = std::min (waiting.size(), events.size());
    Taken taken { 0, stops.now() };

    for (; left > 0; --left)
        if (const auto next = waiting.pop().value(); next.askedAt == taken.stop)
            events[taken.count++] = next.event;

    return taken;
}
} // namespace antinode
