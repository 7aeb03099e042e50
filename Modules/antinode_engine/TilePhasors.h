#pragma once

#include <antinode_model/Oscillation.h>

#include <complex>
#include <cstdint>
#include <vector>

namespace antinode
{
/** Samples in a tile of the synthesis. */
inline constexpr int synthesisTile = 16;

/** Tiles in a group: their phasors have the group's exact one in common. */
inline constexpr int synthesisGroup = 256;

/** Up to how many tiles are evaluated at once. */
inline constexpr int synthesisStrip = 8;

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

/** The phasor X e^{p tau} of an oscillation at the start of any tile, without a transcendental function and without drift.

    The groups of 256 tiles from the first one on are counted in digits of base 64; the phasor is the one at the first tile
    times an exact table entry for every digit that is not 0, times one for the tile in its group. Each factor is rounded once, so the error is some
    2e-16 for every digit, which is 1e-15 after an hour. Docs/Theory.md, section 6.1. */
class TilePhasors
{
public:
    /** @param first  X e^{p tau} at the start of the first tile
        @param rate   Hz
        @param tiles  how many tiles from the first one on can be asked for
        [worker] allocates */
    TilePhasors (const Oscillation&, std::complex<double> first, double rate, std::int64_t tiles);

    /** The phasor at the start of a group. [audio thread] */
    std::complex<double> atGroup (std::uint64_t group) const;

    /** What the phasor at a group's start is to be multiplied with at its tiles: 256 real parts. Behind them there may be read,
        but not used, as far as a strip reaches. [audio thread] */
    const double* turnReal() const { return turns.data(); }

    /** The same, imaginary parts. [audio thread] */
    const double* turnImaginary() const { return turns.data() + synthesisGroup + synthesisStrip; }

private:
    std::complex<double> first;
    std::vector<double> turns;
    std::vector<std::complex<double>> powers; // levels x 64: by whole groups
};
} // namespace antinode
