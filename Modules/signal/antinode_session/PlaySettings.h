#pragma once

#include <antinode_focus/FocusDescription.h>

namespace antinode
{
/** The layout of the notes. */
enum class NoteLayout
{
    spread, ///< Middle C the focus at its own place, the others at places spread over the surface.
    spot    ///< Every note the focus at its own place.
};

/** The parameters of a host for the focus: numbers as a host keeps them, in the units of their names.
    Docs/Manual/parameters.md. */
struct PlaySettings
{
    float xPercent = 50, yPercent = 50; ///< Of the surface's extent, from its left and its lower edge.
    float widthMillimetres = 25;
    TargetShape shape = TargetShape::sinc;
    float peakVelocityMillimetresPerSecond = 40;
    float focusTimeMilliseconds = 25;
    float growth = -1; ///< Below 0: as the focus says, or chosen.
    float brake = 0;   ///< 1 or below: as the focus says, or none.
    AllocationMethod method = AllocationMethod::exact;
    float voltageLimitVolts = 0; ///< 0: as the focus says, or the device's.
    int modeCount = 0;           ///< 0: as the focus says, or chosen.
    float probeXPercent = 50, probeYPercent = 50;
    NoteLayout noteLayout = NoteLayout::spread;
    bool focusOnNote = false; ///< Of which the host knows the latency; what plays has it in its controls.

    bool operator== (const PlaySettings&) const = default;
};
} // namespace antinode
