#pragma once

#include "DesignRequest.h"
#include "UserMessages.h"

#include <string>

namespace antinode
{
/** Says how many notes have no focus, which, and why the last of them failed; empty if all have one. The focus at its
   own position is not meant: DesignProgress::liveError.
    @param sampleRate  that they were designed for, Hz
    [any] */
std::string unplayableNotes (const DesignProgress&, double sampleRate);

/** The same for a window: calm while nearly all others play, for that may be ignored. [any] */
UserMessage unplayableNotesMessage (const DesignProgress&, double sampleRate);
} // namespace antinode
