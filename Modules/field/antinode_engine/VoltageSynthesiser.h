#pragma once

#include "AlignedBuffers.h"
#include "PhasorKernel.h"
#include "SynthesisKernel.h"
#include "TilePhasors.h"

#include <antinode_model/VoltageProgram.h>

#include <Eigen/Core>

#include <complex>
#include <cstdint>
#include <vector>

namespace antinode
{
/** Force oscillations and the allocation mixer: a VoltageProgram as samples.

    Sample n stands for the time t = focusTime + (n - focusSample) / rate, so that the focus falls exactly on a sample.
    Where an oscillation starts or ends on a sample (within 1e-6 of the interval), a band-limited playback gets the mean
   of both sides (the value a band-limited signal has at a step), a zero-order hold the value from there on. Each sample
   is computed from its absolute index, so the output does not depend, to the bit, on the blocks.

    An oscillation Re[X e^{p tau}] is a phasor factored in two: X e^{p tau} at the first sample of a tile of 16, from
   exact tables (TilePhasors), times e^{p j / rate} from another one. So its error does not grow with time: below 1e-12
   of the envelope after 1 s at 192 kHz (where long double is wider than double). Instruction sets differ by as much.
   Docs/Theory.md, section 6.1; Docs/Design/engine.md. */
class VoltageSynthesiser
{
public:
    /** @throws InputError  when the rate is not finite and positive, sizes do not agree, a number of the program is not
       finite, an oscillation ends before it starts, or its envelope overflows double precision [worker] allocates */
    VoltageSynthesiser (const VoltageProgram&, Playback);

    /** The sample on which the focus falls: round (focusTime * rate). [any] */
    std::int64_t focusSample() const { return focus; }

    /** N_b, the number of channels. [any] */
    int channelCount() const { return ceramics; }

    /** Adds the voltages of the samples first .. first + count - 1, times an amplitude, to planar channels.
        @param amplitude  no unit
        @param channels   N_b pointers to count samples each, V; of any alignment
        @param factors    one for every oscillation, which its phasor is multiplied with, or none
        [audio thread] allocates nothing, locks nothing, any count >= 0, any order of blocks; 20 KiB of stack */
    void add (std::int64_t first, int count, double amplitude, double* const* channels,
              const std::complex<double>* factors = nullptr) const;

    /** How many oscillations the program has. [any] */
    int oscillationCount() const { return static_cast<int> (voices.size()); }

    /** Adds the oscillations themselves, before they are shared out among ceramics: add() in two steps, of which mix()
       is the second.
        @param forces  a pointer an oscillation; sample n of the block is added at forces[c][offset + n]
        @param first, count, amplitude, factors  as add's
        [audio thread] as add */
    void addForces (std::int64_t first, int count, double amplitude, double* const* forces, std::ptrdiff_t offset,
                    const std::complex<double>* factors = nullptr) const;

    /** Shares oscillations out: adds allocation (i, c) times forces[c] to channels[i], in the samples from .. to - 1 of
       both.
        @param forces    a pointer an oscillation
        @param channels  N_b pointers, V
        [audio thread] allocates nothing, locks nothing; 20 KiB of stack */
    void mix (const double* const* forces, int from, int to, double* const* channels) const;

    /** Voltages of the samples first .. first + n - 1.
        @param voltages  N_b x n, V
        [audio thread] allocates nothing, locks nothing, any n >= 0, any order of blocks; 40 KiB of stack */
    void process (std::int64_t first, Eigen::Ref<Eigen::MatrixXd> voltages) const;

private:
    /** Where an oscillation starts or ends: its weight is 0 before the sample, `weight` there and 1 after it. */
    struct Edge
    {
        std::int64_t sample = 0;
        double weight = 1;

        double weightAt (std::int64_t n) const { return n < sample ? 0.0 : (n == sample ? weight : 1.0); }
    };

    struct Voice
    {
        Edge start, end;
        std::int64_t firstTile = 0, lastTile = -1; // none if it is silent
        std::int64_t firstStrip = 0;               // that of the first tile
        TilePhasors phasors;

        bool hasEdgeIn (std::int64_t tile) const { return tile == firstTile || tile == lastTile; }
    };

    /** The input of the kernel. */
    struct Tables
    {
        PhasorKernel findPhasors;
        SynthesisKernel kernel;
        std::size_t recordSize = 0;
        AlignedVector<double> records; // oscillations x recordSize: as SynthesisChunk has them
    };

    struct Block;
    class ChunkPlayer;

    Edge edgeAt (double time, double focusTime, Reconstruction) const;
    Voice makeVoice (const Oscillation&, double focusTime, Reconstruction) const;
    Tables makeTables (const VoltageProgram&) const;
    void addBlock (const Block&) const;
    void gatherForces (const double* const* forces, std::size_t firstVoice, int at, int length, SynthesisChunk&) const;

    double rate = 0;
    std::int64_t focus = 0;
    int ceramics = 0;
    std::vector<Voice> voices;
    Tables tables;
};
} // namespace antinode
