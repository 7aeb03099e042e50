#pragma once

#include "TilePhasors.h"

#include <complex>
#include <cstddef>

namespace antinode
{
/** How many oscillations are evaluated before they are mixed, and in how many tiles: their values stay in the fastest cache,
    and the tables are read once for all of these tiles. */
inline constexpr int synthesisChunk = 16, synthesisStrip = 2;

/** An oscillation at a run of tiles. */
template <typename Sample>
struct SoundingOscillation
{
    std::complex<double> anchor;                 ///< What all of its tiles' phasors have in common, V per V of mixing.
    const std::complex<double>* turns = nullptr; ///< Tile by tile: times this gives the phasor at the tile's start.
    const Sample* fine = nullptr;   ///< e^{p j T}, j = 0..63: 64 real parts, then 64 imaginary ones; on a cache line.
    const Sample* mixing = nullptr; ///< N_b: what a ceramic gets of it, V.
};

/** The sounding oscillations of a chunk at a run of tiles, and their values in a strip of it. */
template <typename Sample>
struct SynthesisChunk
{
    static constexpr int samples = synthesisStrip * synthesisTile;

    int count = 0;
    SoundingOscillation<Sample> sounding[synthesisChunk];
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
