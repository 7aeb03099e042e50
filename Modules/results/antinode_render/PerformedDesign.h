#pragma once

#include "PerformedWaveforms.h"

#include <antinode_focus/FocusDesign.h>

namespace antinode
{
/** Waveforms at fingers as a design that can be written and played as a focus is. Its trigger is the first sample; its
    target is the fastest motion that any track wants, at its finger; the fingers rest on the surface, and whoever
    designs the target again does not know of them.
    @param own  the device's own modes, without fingers
    @throws InputError  where a track is longer than a focus may be
    [worker] Docs/Design/tracks.md */
FocusDesign performedDesign (const PerformedWaveforms&, const ModalModel& own);
} // namespace antinode
