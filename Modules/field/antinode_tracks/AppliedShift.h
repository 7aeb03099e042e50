#pragma once

#include "TrackWork.h"

namespace antinode
{
/** Puts what a shift asks for in place of what is wanted. @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.15. */
void applyShift (TrackWork&, const TrackShift&, TrackBand);
} // namespace antinode
