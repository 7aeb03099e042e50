#pragma once

namespace antinode
{
struct TouchOptions
{
    /** A TUIO cursor that has moved farther than this since its last touch gives another one: in fractions of the
        surface, 0 = never. */
    double repeatDistance = 0;
    int touchesPerSecond = 500; ///< The largest number of foci forwarded in any second; all else always is.

    /** TUIO cursors rest as fingers instead of playing foci. */
    bool cursorsRest = false;
};
} // namespace antinode
