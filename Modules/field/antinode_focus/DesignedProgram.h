#pragma once

#include "DesignFocus.h"

namespace antinode
{
/** Gives a design its program: drives and their allocation, with the certificate. Where one drive per mode cannot meet
   the limit, exact rows get further drives before they are refused.
    @param design  with what is wanted, when, and of which modes
    @throws LimitError  when the limits cannot be kept; Cancelled, InputError as solveAllocation
    [worker] Docs/Theory.md, sections 3 and 4. */
void allocateProgram (FocusDesign& design, const ModalModel&);

/** The same as samples of any form.
    @throws InputError  where samples are no answer: on devices with slew limits; LimitError as above
    [worker] Docs/Theory.md, section 4.9. */
void sampleProgram (FocusDesign& design, const ModalModel&, DesignExtent);
} // namespace antinode
