#pragma once

#include <cstdint>

namespace antinode
{
/** The loops of the limiter, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++. */
struct LimiterKernel
{
    /** The number of finite samples from the first on: count if all are finite. */
    int (*finiteSamples) (const double* samples, int count);

    /** Clamps samples to +- limit. @return how many were beyond it */
    std::int64_t (*clamp) (double* samples, int count, double limit);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
LimiterKernel limiterKernel();
} // namespace antinode
