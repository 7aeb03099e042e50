#include "TuioCursors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace antinode
{
void TuioCursors::play (const TuioFrame& frame, std::vector<Touch>& touches, TouchCounters& counters)
{
    if (! advanceTo (frame.sequence))
        return counters.count (TouchFault::staleFrame);

    const std::set<std::int32_t> alive (frame.alive->begin(), frame.alive->end());
    std::erase_if (lastTouches, [&alive] (const auto& entry) { return ! alive.contains (entry.first); });

    for (const auto& cursor : frame.cursors)
    {
        if (alive.contains (cursor.session))
            move (cursor, touches, counters);
        else
            counters.count (TouchFault::brokenFrame);
    }
}

bool TuioCursors::advanceTo (std::int32_t sequence)
{
    // -1 marks a repetition of the whole state, which has no place in the order. Some senders know only 0.
    if (sequence <= 0)
        return true;

    const auto behind = std::int64_t { newest } - sequence;

    if (behind > 0 && behind <= 100)
        return false;

    if (behind > 100)
        lastTouches.clear();

    newest = sequence;
    return true;
}

void TuioCursors::move (const TuioCursor& cursor, std::vector<Touch>& touches, TouchCounters& counters)
{
    const Touch touch { TouchKind::focusAt, false, cursor.x, 1 - cursor.y, 1 };

    if (const auto fault = findFault (touch))
        return counters.count (*fault);

    const auto [last, isNew] = lastTouches.try_emplace (cursor.session, touch);
    const auto distance = std::hypot (touch.x - last->second.x, touch.y - last->second.y);

    if (! isNew && ! (repeatDistance > 0 && distance > repeatDistance))
        return;

    last->second = touch;
    touches.push_back (touch);
}
} // namespace antinode
