#pragma once

// What everything stands on: errors and cancellation, numbers without a field, the convex solver of voltages.
// Rooms and their headers: Docs/Architecture.md.

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>
