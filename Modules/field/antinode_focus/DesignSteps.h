#pragma once

#include "DesignFocus.h"

namespace antinode
{
// designFocus in two steps, for designs of which several are tried and one is finished.

/** What is played until the focus: target, modes, transients, allocation. [worker] As designFocus. */
FocusDesign allocateFocus (const ModalModel&, const FocusDescription&, Playback, DesignExtent);

/** Adds the brake, what the extent asks to know, and remarks.
    @param model  the one that it was allocated for [worker] */
FocusDesign finishDesign (FocusDesign, const ModalModel& model, DesignExtent);
} // namespace antinode
