#pragma once

#include "SynthesisKernel.h"

namespace antinode
{
/** phasors = anchor * turn in a strip of the run, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or
   plain C++. A phasor too small for products in normal numbers counts as 0. */
using PhasorKernel = void (*) (SynthesisChunk&, int strip);

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
PhasorKernel phasorKernel();
} // namespace antinode
