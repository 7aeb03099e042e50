#pragma once

#include <benchmark/benchmark.h>

namespace antinode::bench
{
/** Fused multiplications with additions of whole vectors that the processor does a second now, of independent numbers
   in registers, in the best instruction set: what kernels are measured against. */
double fmaVectorsPerSecond();

/** Lanes of double of such a vector. */
int fmaLanes();

/** Runs something in slices of about a millisecond, each between two measurements of the peak, and sets the counters
    "fma_fraction", the part of the peak, and "ns", per item. A slice whose two peaks differ by more than 2 % was
   disturbed and is dropped; of the others the median counts.
    @param fmas   fused multiplications with additions of single numbers a run
    @param items  mode-samples a run */
template <typename Work>
void measure (benchmark::State&, double fmas, double items, const Work&);
} // namespace antinode::bench

#include "FmaPeakMeasure.h"
