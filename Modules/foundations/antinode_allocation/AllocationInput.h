#pragma once

#include "Allocation.h"

namespace antinode
{
/** Checks that sizes agree, numbers are finite, limits are more than 0 and the guards' weight is not negative.
    @throws InputError  naming the first thing that is wrong. [any] */
void validate (const AllocationProblem&);
} // namespace antinode
