#pragma once

#include "PlanarBuffer.h"
#include "SampleKernel.h"

#include <antinode_model/Oscillation.h>

#include <cstddef>
#include <cstdint>

namespace antinode
{
/** The sample, from the trigger, on which the first of a program's own samples falls.
    @param focusSample  on which the focus falls
    @throws InputError  where they were made for another playback, or not for every ceramic
    [any] */
std::int64_t firstOwnSample (const VoltageProgram&, Playback, std::int64_t focusSample);

/** A free waveform, ready to be played: samples in single precision, each ceramic's one after the other. Read only once
    made. Docs/Theory.md, section 6.6. */
class PlayableSamples
{
public:
    /** @param program  with samples
        @throws InputError  as firstOwnSample, or where a sample is not finite
        [worker] allocates */
    PlayableSamples (const VoltageProgram& program, Playback, std::int64_t focusSample);

    /** From the trigger: none of the samples sounds before it. [any] */
    std::int64_t startSample() const { return start; }

    /** Nothing sounds from this sample on. [any] */
    std::int64_t endSample() const { return end; }

    /** The number of channels. [any] */
    int channelCount() const { return static_cast<int> (samples.size()); }

    /** What they take of the memory. [any] */
    std::size_t bytes() const { return channelCount() * static_cast<std::size_t> (end - start) * sizeof (float); }

    /** Adds the samples first .. first + count - 1, times an amplitude, to planar channels.
        @param amplitude  no unit
        @param channels   channelCount() pointers, V; sample n of the block is added at channels[i][offset + n]
        [audio thread] allocates nothing, locks nothing, any count >= 0, any order of blocks */
    void add (std::int64_t first, int count, double amplitude, double* const* channels,
              std::ptrdiff_t offset = 0) const;

    /** The same, where a voice fades.
        @param gains  of each sample of the block
        [audio thread] as add */
    void addFaded (std::int64_t first, int count, double amplitude, const double* gains, double* const* channels) const;

private:
    std::int64_t start = 0, end = 0;
    PlanarBuffer<float> samples;
    SampleKernel kernel = sampleKernel();
};
} // namespace antinode
