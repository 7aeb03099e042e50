#pragma once

#include "FocusDesign.h"

#include <functional>

namespace antinode
{
/** The two halves of a design with chosen modes, as weighModes() calls them. */
struct ModeTrials
{
    std::function<FocusDesign (const ModeChoice&)> choose; ///< What is controlled, without a program.
    std::function<FocusDesign (FocusDesign)> allocate;     ///< The same with its program and certificate.
};

/** Whether a focus leaves the number of modes open, and more of them can need less voltage: with exact rows and
   guards at the least norm. [any] Docs/Design/drives.md */
bool leavesModesOpen (const FocusDescription&);

/** A focus with as many modes as a design of it controls, where it leaves their number open and the design has one
    focus; else as it is. [any] Docs/Design/estimation.md */
FocusDescription withModesOf (FocusDescription, const FocusDesign&);

/** A design with its program, where the number of modes is open: the fewest that capture 0.99, or more where these
   need much of a limit and more modes need less of it. Says in the choices what was weighed.
    @throws LimitError  where no number keeps the limits; Cancelled, InputError as the trials
    [worker] Docs/Theory.md, section 2.3 */
FocusDesign weighModes (const ModalModel&, const ModeTrials&);
} // namespace antinode
