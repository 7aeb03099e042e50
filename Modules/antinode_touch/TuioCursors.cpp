#include "TuioCursors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace antinode
{
void TuioCursors::play (const TuioFrame& frame, std::vector<Touch>& touches, TouchCounters& counters)
{
    if (! advanceTo (frame.sequence, touches))
        return counters.count (TouchFault::staleFrame);

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

bool TuioCursors::advanceTo (std::int32_t sequence, std::vector<Touch>& touches)
{
    // -1 marks a repetition of the whole state, which has no place in the order. Some senders know only 0.
    if (sequence <= 0)
        return true;

    const auto behind = std::int64_t { newest } - sequence;

    if (behind > 0 && behind <= 100)
        return false;

    if (behind > 100)
        liftAll (touches);

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
