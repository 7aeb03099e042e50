#pragma once

#include "Robustness.h"
#include "RowOrigin.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_model/ModalModel.h>

namespace antinode
{
/** An allocation problem with guard rows for what errors of the device do to the velocities at the focus: the sum of
   their squares is the expected squared error of all modes, in (m/s)^2 kg. Hard rows stay as they are. Rows that cost
   less than the energy that it takes to move them are left out, and of the others the weakest beyond 4000.
    @param problem  exact rows, with guards
    @throws InputError  as solveAllocation
    [worker] Docs/Theory.md, section 7.5. */
AllocationProblem withRobustRows (AllocationProblem problem, const ModalModel&, const RowOrigin&, const Robustness&);
} // namespace antinode
