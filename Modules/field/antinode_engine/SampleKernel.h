#pragma once

namespace antinode
{
/** The loop of sampled voices, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++. */
struct SampleKernel
{
    /** Adds so many times the samples; each sum is the same to the bit anywhere in a block. [audio thread] */
    void (*addScaled) (const float* from, double amplitude, double* to, int count);

    /** The same, each sample times a gain of its own too. [audio thread] */
    void (*addFaded) (const float* from, const double* gains, double amplitude, double* to, int count);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
SampleKernel sampleKernel();
} // namespace antinode
