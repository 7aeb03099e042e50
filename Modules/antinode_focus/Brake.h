#pragma once

#include "FocusDesign.h"

namespace antinode
{
/** Adds the brakes of all controlled modes to a design, within the voltage limits: they take over when its drives are released.
    Where the limit does not allow the whole brake, it is weakened and a warning says so.
    [worker] Docs/Theory.md, section 3.4. */
void appendBrake (FocusDesign&, const ModalModel&);
} // namespace antinode
