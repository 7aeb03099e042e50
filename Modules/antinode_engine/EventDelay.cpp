#include "EventDelay.h"

#include <algorithm>

namespace antinode
{
std::span<const FocusEvent> EventDelay::process (std::span<const FocusEvent> events, int count, std::int64_t delay)
{
    for (const auto& event : events)
    {
        if (waiting == mostWaiting)
            break;

        lastDue = std::max (lastDue, clock + event.offset + delay);
        ring[(first + waiting++) % mostWaiting] = { lastDue, event };
    }

    std::size_t taken = 0;

    for (; waiting > 0 && taken < mostPerBlock && ring[first].due < clock + count; --waiting)
    {
        out[taken] = ring[first].event;
        out[taken++].offset = static_cast<int> (std::max<std::int64_t> (0, ring[first].due - clock));
        first = (first + 1) % mostWaiting;
    }

    clock += count;
    return { out.data(), taken };
}
} // namespace antinode
