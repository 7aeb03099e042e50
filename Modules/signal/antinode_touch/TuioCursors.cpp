#include "TuioCursors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace antinode
{
void TuioCursors::play (const TuioFrame& frame, Time now, std::vector<Touch>& touches, TouchCounters& counters)
{
    if (! advanceTo (frame.sequence, now, touches))
        return counters.count (TouchFault::staleFrame);

    heard = now;

    const std::set<std::int32_t> alive (frame.alive->begin(), frame.alive->end());
    std::erase_if (lastTouches,
                   [&] (const auto& entry)
                   {
                       const auto hasLeft = ! alive.contains (entry.first);

                       if (hasLeft && options.cursorsRest)
                           touches.push_back ({ TouchKind::lift, false, 0, 0, 1, fingerOf (entry.first) });

                       return hasLeft;
                   });

    for (const auto& cursor : frame.cursors)
    {
        if (alive.contains (cursor.session))
            move (cursor, touches, counters);
        else
            counters.count (TouchFault::brokenFrame);
    }
}

void TuioCursors::liftAll (std::vector<Touch>& touches)
{
    for (const auto& [session, touch] : lastTouches)
        if (options.cursorsRest)
            touches.push_back ({ TouchKind::lift, false, 0, 0, 1, fingerOf (session) });

    lastTouches.clear();
}

std::int64_t TuioCursors::fingerOf (std::int32_t session) const
{
    return (std::int64_t { source } << 32) + session;
}

bool TuioCursors::advanceTo (std::int32_t sequence, Time now, std::vector<Touch>& touches)
{
    constexpr auto longestDelay = std::chrono::milliseconds (200); // of a packet that others overtake
    constexpr int longestGap = 100, first = 1;                     // frames

    // -1 marks a repetition of the whole state, which has no place in the order. Some senders know only 0.
    if (sequence <= 0)
        return true;

    if (const auto behind = std::int64_t { newest } - sequence; behind > 0)
    {
        if (sequence != first && behind <= longestGap && now - heard <= longestDelay)
            return false;

        liftAll (touches);
    }

    newest = sequence;
    return true;
}

void TuioCursors::move (const TuioCursor& cursor, std::vector<Touch>& touches, TouchCounters& counters)
{
    const auto kind = options.cursorsRest ? TouchKind::rest : TouchKind::focusAt;
    const Touch touch { kind, false, cursor.x, 1 - cursor.y, 1, options.cursorsRest ? fingerOf (cursor.session) : 0 };

    if (const auto fault = findFault (touch))
        return counters.count (*fault);

    const auto [last, isNew] = lastTouches.try_emplace (cursor.session, touch);
    const auto distance = std::hypot (touch.x - last->second.x, touch.y - last->second.y);
    const auto isFar = options.repeatDistance > 0 && distance > options.repeatDistance;

    if (! isNew && ! isFar && ! options.cursorsRest)
        return;

    last->second = touch;
    touches.push_back (touch);
}
} // namespace antinode
