#pragma once

#include "TouchedNodes.h"
#include "TrackWork.h"

namespace antinode
{
/** What a design of tracks holds at once, bytes. */
struct TrackBytes
{
    double samples = 0; ///< Of all that is the longer the longer tracks last.
    double tables = 0;  ///< Of the shapes along paths.

    double sum() const { return samples + tables; } // [any]
};

/** What a design with such samples holds. [any] */
TrackBytes trackBytes (const ModalModel&, const WaveformsDescription&, const TrackSpan&, const TouchedNodes&);

/** Whether that is as much as designs may hold, 1 GiB, or less. [any] */
bool isWithinMemory (TrackBytes);

/** Checks the same. @param seconds  that the tracks last
    @throws InputError  how much it is, and how long tracks may last
    [any] */
void requireTrackMemory (TrackBytes, double seconds);

/** Checks, before they are computed, that the shapes along all paths are within it too.
    @throws InputError  how much they take, and which share of the paths' length is allowed
    [any] */
void requirePathMemory (const ModalModel&, const WaveformsDescription&);
} // namespace antinode
