#pragma once

#include "Touch.h"
#include "TouchCounters.h"
#include "TouchOptions.h"
#include "TuioFrame.h"

#include <chrono>
#include <map>
#include <vector>

namespace antinode
{
/** The cursors of one TUIO source, and the touches that they give. */
class TuioCursors
{
public:
    using Time = std::chrono::steady_clock::time_point;

    /** Without a frame for so long a source has ended: TUIO repeats what is alive about once a second. */
    static constexpr auto longestSilence = std::chrono::seconds (3);

    /** @param source  a number that no other source has */
    TuioCursors (const TouchOptions& optionsToUse, std::int32_t sourceToUse)
        : options (optionsToUse), source (sourceToUse)
    {
    }

    /** A cursor gives a touch where it is first seen on the surface, of amplitude 1. Where cursors rest as fingers,
        each place that its source sends gives one, and so does its leaving. One that is not alive any more is
        forgotten. Frames older than the newest are dropped; one with the newest's number is the rest of it, or a
        repetition. An older one is that of a source that was restarted where it is the first, more than 100 behind, or
        comes later than any network keeps packets.
        @param frame  has its alive
        @param now    times do not go back
        [any] */
    void play (const TuioFrame& frame, Time now, std::vector<Touch>&, TouchCounters&);

    /** Whether no frame has come for longestSilence. [any] */
    bool hasEnded (Time now) const { return now - heard > longestSilence; }

    /** Forgets all cursors; fingers are lifted. [any] */
    void liftAll (std::vector<Touch>&);

private:
    bool advanceTo (std::int32_t sequence, Time now, std::vector<Touch>&);
    void move (const TuioCursor&, std::vector<Touch>&, TouchCounters&);
    std::int64_t fingerOf (std::int32_t session) const;

    TouchOptions options;
    std::int32_t source;
    std::int32_t newest = 0;
    Time heard {};                             ///< When the last frame came.
    std::map<std::int32_t, Touch> lastTouches; ///< By session.
};
} // namespace antinode
