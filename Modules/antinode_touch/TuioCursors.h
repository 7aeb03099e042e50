#pragma once

#include "Touch.h"
#include "TouchCounters.h"
#include "TuioFrame.h"

#include <map>
#include <vector>

namespace antinode
{
/** The cursors of one TUIO source, and the touches that they give. */
class TuioCursors
{
public:
    /** @param repeatDistance  see TouchOptions */
    explicit TuioCursors (double repeatDistanceToUse) : repeatDistance (repeatDistanceToUse) {}

    /** A cursor gives a touch where it is first seen on the surface, of amplitude 1. One that is not alive any more is
        forgotten. Frames older than the newest are dropped; one with the newest's number is the rest of it, or a
        repetition, which changes nothing; one more than 100 behind is that of a source that was restarted.
        @param frame  has its alive
        [any] */
    void play (const TuioFrame& frame, std::vector<Touch>&, TouchCounters&);

private:
    bool advanceTo (std::int32_t sequence);
    void move (const TuioCursor&, std::vector<Touch>&, TouchCounters&);

    double repeatDistance;
    std::int32_t newest = 0;
    std::map<std::int32_t, Touch> lastTouches; ///< By session.
};
} // namespace antinode
