#pragma once

#include "TouchSettings.h"

#include <array>
#include <chrono>
#include <vector>

namespace antinode
{
/** Where fingers were seen lately, and where those that move will be. One thread at a time.
    Docs/Design/fingers.md */
class FingerMovement
{
public:
    using Clock = std::chrono::steady_clock;

    /** What the parameters say at a time, not before those that were noted. [session's thread] */
    void note (const TouchSettings&, Clock::time_point);

    /** Whether any finger is on its way. It is seen to have stopped when its next place stays out. [session's thread]
     */
    bool isAnyMoving (Clock::time_point now) const;

    /** What was noted last, with the fingers that move where they will be after a time, on the surface. A finger that
        leaps stays where it is. [session's thread] */
    TouchSettings expected (Clock::time_point now, Clock::duration ahead) const;

    /** What was noted when the fingers came to rest: they have stayed within a two-hundredth of the surface since then.
        [session's thread] */
    const TouchSettings& rest() const { return resting; }

    /** For how long they have rested. [session's thread] */
    Clock::duration restedFor (Clock::time_point now) const { return now - restsSince; }

private:
    struct Seen
    {
        Clock::time_point time;
        double x = 0, y = 0; // % of the surface
    };

    using Way = std::vector<Seen>; // places that differ from the one before, the oldest first

    static void noteFinger (Way&, const FingerSettings&, Clock::time_point);
    static bool isMoving (const Way&, Clock::time_point now);

    TouchSettings newest, resting;
    Clock::time_point restsSince {};
    std::array<Way, mostFingers> ways;
};
} // namespace antinode
