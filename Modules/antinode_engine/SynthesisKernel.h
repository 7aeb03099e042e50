#pragma once

#include "TilePhasors.h"

#include <cstddef>

namespace antinode
{
/** How many oscillations are evaluated in a strip of tiles before they are mixed: their values stay in the fastest cache. */
inline constexpr int synthesisChunk = 24;

/** An oscillation at a run of tiles. Not initialised: the audio thread makes and fills many of them. */
template <typename Sample>
struct SoundingOscillation
{
    double anchorReal, anchorImaginary; ///< What all of its tiles' phasors have in common, V per V of mixing.
    const double* turnReal;             ///< Tile by tile: times this the anchor is the phasor at the tile's start.
    const double* turnImaginary;        ///< As long; a strip may be read behind the run's last tile.
    const Sample* fine;   ///< e^{p j T}, j = 0..15: 16 real parts, then 16 imaginary ones; on a cache line.
    const Sample* mixing; ///< N_b: what a ceramic gets of it, V.
};

/** The sounding oscillations of a chunk at a run of tiles, and their values in a strip of it. */
template <typename Sample>
struct SynthesisChunk
{
    static constexpr int samples = synthesisStrip * synthesisTile;

    int count = 0;
    SoundingOscillation<Sample> sounding[synthesisChunk];
    alignas (
        64) Sample phasors[synthesisChunk * 2 * synthesisStrip]; ///< Real, then imaginary parts at the strip's tiles.
    alignas (64) Sample values[synthesisChunk * samples];
};

/** The two loops of the synthesis, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++.

    Every sample is computed by the same operations in the same order, in whichever lane and for whichever range of samples. */
template <typename Sample>
struct SynthesisKernel
{
    /** values = Re[anchor * turn * fine] in the run's tiles tile .. tile + tiles - 1, at most a strip. A phasor too small for
        products in normal numbers counts as 0. */
    void (*evaluate) (SynthesisChunk<Sample>&, int tile, int tiles);

    /** channels[i][offset + j - begin] += sum of mixing[i] * values[j], i < ceramics, for the samples j = begin .. end - 1 of the
        strip. Oscillations are added in their order. */
    void (*mix) (const SynthesisChunk<Sample>&, int begin, int end, int ceramics, Sample* const* channels,
                 std::ptrdiff_t offset);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
template <typename Sample>
SynthesisKernel<Sample> synthesisKernel();
} // namespace antinode
