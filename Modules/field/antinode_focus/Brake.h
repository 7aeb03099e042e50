#pragma once

#include "FocusDesign.h"

namespace antinode
{
/** Adds to a design, within the voltage limits, what brings all modes that still matter by then to rest after the last
   focus: their velocities and displacements are exactly 0 at the end, the other modes are guarded. Begins when the
   drives are released. Where the limits do not allow rest in the requested time, the brake takes longer and a warning
   says so.
    @throws InputError  when the requested time is too short for any brake, or as solveAllocation
    [worker] Docs/Theory.md, section 3.4. */
void appendBrake (FocusDesign&, const ModalModel&);

/** Whether a focus asks for a brake. [any] */
bool hasBrake (const TransientChoice&);
} // namespace antinode
