#pragma once

#include "PlateKernel.h"

namespace antinode
{
/** The sums of modes at the probes, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++. */
struct ProbeKernel
{
    /** Adds what up to 128 modes do; the first ones begin new sums. A single probe is added up by the PlateKernel. */
    void (*hear) (const PlateTile&, std::ptrdiff_t firstMode);

    /** Writes the velocities when all modes have been added. */
    void (*write) (const PlateTile&);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
ProbeKernel probeKernel();
} // namespace antinode
