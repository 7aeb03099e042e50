#pragma once

#include "AlignedBuffers.h"

#include <antinode_model/VoltageProgram.h>

#include <complex>
#include <cstdint>
#include <vector>

namespace antinode
{
/** Samples in a tile of the synthesis. */
inline constexpr int synthesisTile = 16;

/** Tiles in a strip, whose phasors are computed at once. Strips are aligned to the absolute index of samples. */
inline constexpr int synthesisStrip = 8;

/** Samples in a strip. */
inline constexpr int stripSamples = synthesisStrip * synthesisTile;

/** Strips in a group: their phasors have the group's exact one in common. */
inline constexpr int synthesisGroup = 8;

/** The tile of a sample. [any] */
inline std::int64_t tileIndex (std::int64_t sample)
{
    return sample >= 0 ? sample / synthesisTile : -((-sample + synthesisTile - 1) / synthesisTile);
}

/** The strip of a tile. [any] */
inline std::int64_t stripIndex (std::int64_t tile)
{
    return tile >= 0 ? tile / synthesisStrip : -((-tile + synthesisStrip - 1) / synthesisStrip);
}

/** The product, without the search for infinities of std::complex. [any] */
inline std::complex<double> product (std::complex<double> one, std::complex<double> other)
{
    return { one.real() * other.real() - one.imag() * other.imag(),
             one.real() * other.imag() + one.imag() * other.real() };
}

/** e^{p t} to the precision of double, however large the phase: computed in extended precision.
    @param time  s
    [worker] */
std::complex<double> exponential (const Oscillation&, long double time);

/** The phasor X e^{p tau} of an oscillation at the start of any tile, without a transcendental function and without
   drift.

    The groups of 64 tiles from the first strip on are counted in digits of base 64; the phasor is the one at the first
   strip times an exact table entry for every digit that is not 0, times one for the tile in its group. Each factor is
   rounded once, so the error is some 2e-16 for every digit, which is 1e-15 after an hour. Docs/Theory.md, section 6.1.
 */
class TilePhasors
{
public:
    /** @param first   X e^{p tau} at the start of the first strip
        @param rate    Hz
        @param strips  the number of available strips from the first one on
        [worker] allocates */
    TilePhasors (const Oscillation&, std::complex<double> first, double rate, std::int64_t strips);

    /** The phasor at the start of a group. [audio thread] */
    std::complex<double> atGroup (std::uint64_t group) const
    {
        auto phasor = first;

        for (const auto* level = powers.data(); group > 0; level += digitBase, group /= digitBase)
            if (const auto digit = group % digitBase; digit > 0)
                phasor = product (phasor, level[digit]);

        return phasor;
    }

    /** The factors of the phasor at a group's start for its tiles: for each of its strips 8 real, then 8 imaginary
        parts, on a cache line. [audio thread] */
    const double* turns() const { return turnsOfGroup.data(); }

private:
    static constexpr std::uint64_t digitBase = 64;

    std::complex<double> first;
    AlignedVector<double> turnsOfGroup;
    std::vector<std::complex<double>> powers; // levels x 64: by whole groups
};
} // namespace antinode
