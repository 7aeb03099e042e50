#include "FocusEvents.h"

#include <algorithm>

namespace antinode
{
/** Those of the ring that are due before a sample of the clock. */
void EventDelay::takeDue (std::int64_t end)
{
    for (; waiting > 0 && taken < mostPerBlock && ring[first].due < end; --waiting)
    {
        out[taken] = ring[first].event;
        out[taken++].offset = static_cast<int> (std::max<std::int64_t> (0, ring[first].due - clock));
        first = (first + 1) % mostWaiting;
    }
}

std::span<const FocusEvent> EventDelay::process (std::span<const FocusEvent> events, int count, std::int64_t delay,
                                                 bool isHeld)
{
    taken = 0;

    for (const auto& event : events)
    {
        if (isStop (event))
        {
            if (! isHeld)
                takeDue (clock + event.offset);

            waiting = 0;
            lastDue = clock + event.offset;
            taken = std::min (taken, mostPerBlock - 1); // There is room for a stop.
            out[taken++] = event;
        }
        else if (waiting < mostWaiting)
        {
            lastDue = std::max (lastDue, clock + event.offset + delay);
            ring[(first + waiting++) % mostWaiting] = { lastDue, event };
        }
    }

    if (! isHeld)
        takeDue (clock + count);

    clock += count;
    return { out.data(), taken };
}
} // namespace antinode
