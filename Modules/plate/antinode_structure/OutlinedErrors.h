#pragma once

#include "OutlinedProblem.h"

namespace antinode
{
/** Estimated relative errors of the frequencies of a solution, from a second one on cells that are larger everywhere:
   at corners, holes and patches, too.
    @return  one value a mode, positive
    @throws InputError  where the plate cannot be solved on larger cells
    [worker] Docs/Theory.md, section 1.13. */
Eigen::VectorXd frequencyErrors (const OutlinedSolution&);
} // namespace antinode
