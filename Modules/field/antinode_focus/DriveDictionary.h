#pragma once

#include "DriveAllocation.h"
#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** The growth rates of a dictionary, as multiples of what a mode's drives take for 1: few modes need many of them, many
   modes make up for each other's. [any] Docs/Theory.md, section 4.8. */
std::vector<double> dictionaryGrowths (std::size_t modes);

/** The dictionary: several drives per mode instead of one. At the mode's damped frequency, for each growth rate an
   oscillation that is at its crest at the focus and one that crosses 0 there, each with an envelope of 1 at the focus.
   A growth rate of 1 is the chosen one, or the mode's decay rate where that is more. All drives begin together, where
   the window, the maximum duration or the trigger says; those so steep that 40 e-folds fit begin later. They rise by (1
   - e^{-r tau})^2, r that of the release, so that neither value nor slope jumps at the start, and are released after
   the focus.
    @param growth  gamma of each mode
    @return        the drives of the first mode, then of the second, ...
    [any] Docs/Theory.md, section 4.8. */
DriveList dictionaryDrives (const ModalModel&, const FocusDescription&, const std::vector<int>& modes,
                            const std::vector<double>& growth);

/** The dictionary's drives within 1.005 of the least peak voltage, exact terminal rows, guards soft. The solver sees a
   grid that is half as fine as that of other methods, with limits that are tightened for it; the certificate's ratios
   are those on the fine one.
    @throws InputError  as solveAllocation
    [worker] Docs/Theory.md, section 4.8. */
Allocation allocateDictionary (AllocationProblem, const DriveList&, DriveSpan);
} // namespace antinode
