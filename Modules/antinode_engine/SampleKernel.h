#pragma once

namespace antinode
{
/** The loop of sampled voices, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++. */
template <typename Sample>
struct SampleKernel
{
    /** Adds so many times the samples; each sum is the same to the bit anywhere in a block. [audio thread] */
    void (*addScaled) (const float* from, Sample amplitude, Sample* to, int count);

    /** The same, each sample times a gain of its own too. [audio thread] */
    void (*addFaded) (const float* from, const Sample* gains, Sample amplitude, Sample* to, int count);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
template <typename Sample>
SampleKernel<Sample> sampleKernel();
} // namespace antinode
