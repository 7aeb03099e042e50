#pragma once

#include <algorithm>
#include <cstddef>

namespace antinode
{
/** Samples in a tile of the real-time plate, and what its modes are padded to: groups of four of the widest vectors. */
inline constexpr int plateTile = 16, plateModeGroup = 32;

/** The largest number of modes summed at once for the probes, and the number of probes at once if there are enough. */
inline constexpr int plateModesHeard = 128, plateProbeGroup = 8;

/** The modes of a plate and one tile of its samples. All arrays start on a cache line; modes are padded with zeros.
   Where many rows belong to a mode, a group of 32 modes has its rows in one place: rows that are far apart by a power
   of two would drive each other out of the first cache.

    In the coordinates (q', Im y) of section 6.5 of Docs/Theory.md a mode goes from one sample to the next with

        v = a11 x1 + a12 x2 + h,   x2 <- a21 x1 + a22 x2,   x1 <- v + h

    where h is half of what the sample's force adds, and v the velocity at the sample.

    The force on a complex mode has two parts, which add to either coordinate, and both coordinates at the sample are
   heard. So each group of 32 modes has its drive twice, for either coordinate, and after the velocities in `motion` the
   second coordinates; the shapes are those of twice as many modes. */
struct PlateTile
{
    int modes = 0, ceramics = 0, probes = 0; ///< Complex modes count twice, as they are heard.
    bool complex = false;
    int samples = 0;                    ///< 1..16
    bool last = false;                  ///< Whether the tile ends here: then states below 1e-200 become 0.
    const double* drive = nullptr;      ///< groups x ceramics x 32: half of what 1 V for one sample adds to x1.
    const double* transition = nullptr; ///< groups x 4 x 32: a11, a12, a21, a22.
    const double* shapes =
        nullptr; ///< groups x probes x 32; of eight probes at a time modes x 8, of the rest probes x 32.
    const double* voltages = nullptr; ///< ceramics x 16, V; finite also behind the last sample.
    double* state = nullptr;          ///< groups x 2 x 32
    double* motion = nullptr;         ///< 4 groups x 16 x 32: velocities of the modes that are summed at once; finite.
    double* sums = nullptr;           ///< probes x 16 x 8: partial sums of the velocities at the probes.
    double* velocities = nullptr;     ///< probes x 16, m/s
};

/** Some modes of a plate: the same arrays from one mode on. */
struct PlateModes
{
    bool first; ///< Whether they are the plate's first ones.
    const double *drive, *transition, *shapes;
    double *state, *motion;
};

/** The data of the modes from one on in its group. [audio thread] */
inline PlateModes plateModes (const PlateTile& tile, std::ptrdiff_t mode)
{
    const auto lane = mode % plateModeGroup, group = mode - lane;
    return { mode == 0,
             tile.drive + group * tile.ceramics + lane,
             tile.transition + group * 4 + lane,
             tile.shapes + group * tile.probes + lane,
             tile.state + group * 2 + lane,
             tile.motion + group % plateModesHeard * plateTile + lane };
}

/** The data of complex modes, of which a group is heard as two, from one on in its first.
    @param mode  as it is heard, in the first of its two groups
    [audio thread] */
inline PlateModes plateComplexModes (const PlateTile& tile, std::ptrdiff_t mode)
{
    const auto lane = mode % plateModeGroup, heard = mode - lane, group = heard / 2;
    return { mode == 0,
             tile.drive + heard * tile.ceramics + lane,
             tile.transition + group * 4 + lane,
             tile.shapes + heard * tile.probes + lane,
             tile.state + group * 2 + lane,
             tile.motion + heard % plateModesHeard * plateTile + lane };
}

/** The end of the modes that are summed at once, from one on. [audio thread] */
inline std::ptrdiff_t plateModesEnd (const PlateTile& tile, std::ptrdiff_t firstMode)
{
    return std::min<std::ptrdiff_t> (tile.modes, firstMode + plateModesHeard);
}

/** Advances up to 128 modes of the plate by the samples of a tile, in the form for this processor: AVX-512, AVX2 with
   FMA, SSSE3 or plain C++. Every sample is computed by the same operations in the same order, wherever it lies in a
   tile. */
using PlateKernel = void (*) (const PlateTile&, std::ptrdiff_t firstMode);

/** The kernel for the processor that runs; hwy::SetSupportedTargetsForTest chooses another one. [worker] */
PlateKernel plateKernel();
} // namespace antinode
