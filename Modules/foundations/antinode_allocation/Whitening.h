#pragma once

#include "WhitenedAllocation.h"

namespace antinode
{
/** Whitens a valid problem that wants something. Where drives are combinations of others (to 1e-5 of their length) each
   gets a sample of 1e-4 of its length that no other drive has, at the end of the basis. Rows that nothing moves and
   that want 0 are left out.
    @throws InputError  when a hard row cannot be met, naming it
    [worker] 4 N_s N_d^2 */
WhitenedAllocation whiten (const AllocationProblem&);
} // namespace antinode
