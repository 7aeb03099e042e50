#pragma once

#include <cstdint>

namespace antinode
{
/** The loops of limiter and ramp, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++. */
template <typename Sample>
struct LimiterKernel
{
    /** The number of finite samples from the first on: count if all are finite. */
    int (*finiteSamples) (const Sample* samples, int count);

    /** Clamps samples to +- limit. @return how many were beyond it */
    std::int64_t (*clamp) (Sample* samples, int count, Sample limit);

    /** Multiplies with gains. */
    void (*multiply) (Sample* samples, const Sample* gains, int count);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
template <typename Sample>
LimiterKernel<Sample> limiterKernel();
} // namespace antinode
