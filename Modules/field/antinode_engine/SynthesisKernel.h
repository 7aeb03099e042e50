#pragma once

#include "TilePhasors.h"

#include <cstddef>

namespace antinode
{
/** The number of oscillations played at once: their data for every tile stays in the fastest cache. */
inline constexpr int synthesisChunk = 64;

/** An oscillation at a run of strips. Not initialised: the audio thread makes and fills many of them. */
struct SoundingOscillation
{
    double anchorReal, anchorImaginary; ///< The common factor of the phasors of some strips, V per V of mixing.
    const double* turns;                ///< Strip by strip: times this the anchor is the phasor at each tile's start.
};

/** The sounding oscillations of a chunk at a run of tiles, and their values in a tile. */
struct SynthesisChunk
{
    int count = 0;
    SoundingOscillation sounding[synthesisChunk];

    /** One an oscillation, on a cache line: e^{p j T}, j = 0..15, 16 real parts, then 16 imaginary ones; then what the
       ceramics get of it, V. All in one place, as all is read together. */
    const double* records[synthesisChunk];

    alignas (
        64) double phasors[synthesisChunk * 2 * synthesisStrip]; ///< Real, then imaginary parts at a strip's tiles.
    alignas (64) double values[synthesisChunk * synthesisTile];
};

/** Samples of a strip, and where they are added. */
struct SynthesisTarget
{
    int begin, end;             ///< The samples begin .. end - 1 of the strip.
    int firstCeramic, ceramics; ///< The first one is that of channels[0].
    double* const* channels;    ///< channels[i][offset + j] gets sample j of the strip.
    std::ptrdiff_t offset;
};

/** The loops of the synthesis, in the form for this processor: AVX-512, AVX2 with FMA, SSSE3 or plain C++.

    Every sample is computed by the same operations in the same order, in whichever lane and for whichever range of
   samples. */
struct SynthesisKernel
{
    /** Adds sum of mixing * Re[phasor * fine], oscillation by oscillation. */
    void (*add) (SynthesisChunk&, const SynthesisTarget&);

    /** values = Re[phasor * fine] in a tile of the strip, where they can be changed before they are added. */
    void (*evaluate) (SynthesisChunk&, int tile);

    /** As add does, with the values of evaluate, in its tile. */
    void (*addValues) (SynthesisChunk&, const SynthesisTarget&);
};

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
SynthesisKernel synthesisKernel();
} // namespace antinode
