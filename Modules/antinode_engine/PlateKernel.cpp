#include "PlateKernel.h"

#include <cstddef>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/PlateKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

using Index = std::ptrdiff_t;
constexpr hn::ScalableTag<double> tag;
using Vector = hn::VFromD<hn::ScalableTag<double>>;
constexpr Index lanes = static_cast<Index> (hn::MaxLanes (tag));
constexpr Index groupModes = plateModeGroup;
constexpr int samplesAtOnce = 4;
constexpr Index probeGroup = plateProbeGroup, vectorsOfEight = probeGroup / lanes;
constexpr Index samplesOfEight = (HWY_TARGET <= HWY_AVX3 ? 16 : 8) / vectorsOfEight;
constexpr int sumsAtOnce = HWY_TARGET <= HWY_AVX3 ? 4 : 2; // beside the samples: as many sums as there are registers

/** Some modes: what they are and what they do. The numbers of a sample belong to as many vectors. */
struct Modes
{
    const double *drive, *transition, *shapes;
    double *state, *motion;
};

/** What a group of modes reads and writes, from one of its modes on. */
HWY_INLINE Modes modesAt (const PlateTile& tile, Index mode)
{
    const auto group = mode / groupModes, lane = mode % groupModes;
    return { tile.drive + group * groupModes * tile.ceramics + lane, tile.transition + group * groupModes * 4 + lane,
             tile.shapes + group * groupModes * tile.probes + lane, tile.state + group * groupModes * 2 + lane,
             tile.motion + mode % plateModesHeard / groupModes * (plateTile * groupModes) + lane };
}

/** The forces of some modes at some samples: half of what the voltages add. */
template <int samples>
HWY_INLINE void drive (const PlateTile& tile, const Modes& modes, Index sample, Vector (*forces)[sumsAtOnce])
{
#pragma GCC unroll 16
    for (Index n = 0; n < samples; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < sumsAtOnce; ++v)
            forces[n][v] = hn::Zero (tag);

    for (Index i = 0; i < tile.ceramics; ++i)
    {
        Vector drive[sumsAtOnce];

#pragma GCC unroll 16
        for (Index v = 0; v < sumsAtOnce; ++v)
            drive[v] = hn::Load (tag, modes.drive + i * groupModes + v * lanes);

#pragma GCC unroll 16
        for (Index n = 0; n < samples; ++n)
        {
            const auto voltage = hn::Set (tag, tile.voltages[i * plateTile + sample + n]);

#pragma GCC unroll 16
            for (Index v = 0; v < sumsAtOnce; ++v)
                forces[n][v] = hn::MulAdd (drive[v], voltage, forces[n][v]);
        }
    }
}

/** Advances some modes by some samples; forces and states stay in registers. A single probe is added up here, too. */
template <int samples, bool single>
HWY_INLINE void advance (const PlateTile& tile, const Modes& modes, Index sample, Vector* first, Vector* second)
{
    Vector forces[samples][sumsAtOnce];
    drive<samples> (tile, modes, sample, forces);

#pragma GCC unroll 16
    for (Index n = 0; n < samples; ++n)
    {
        auto* target = tile.sums + (sample + n) * lanes;
        [[maybe_unused]] auto sum = single ? hn::Load (tag, target) : hn::Zero (tag);

#pragma GCC unroll 16
        for (Index v = 0; v < sumsAtOnce; ++v)
        {
            const auto* turn = modes.transition + v * lanes;
            const auto half = forces[n][v];
            const auto velocity = hn::MulAdd (hn::Load (tag, turn), first[v],
                                              hn::MulAdd (hn::Load (tag, turn + groupModes), second[v], half));
            second[v] = hn::MulAdd (hn::Load (tag, turn + 2 * groupModes), first[v],
                                    hn::Mul (hn::Load (tag, turn + 3 * groupModes), second[v]));
            first[v] = hn::Add (velocity, half);

            if constexpr (single)
                sum = hn::MulAdd (hn::Load (tag, modes.shapes + v * lanes), velocity, sum);
            else
                hn::Store (velocity, tag, modes.motion + (sample + n) * groupModes + v * lanes);
        }

        if constexpr (single)
            hn::Store (sum, tag, target);
    }
}

/** States below 1e-200 become 0 where a tile ends. */
HWY_INLINE Vector settled (const PlateTile& tile, Vector state)
{
    return hn::IfThenElseZero (hn::Ge (hn::Abs (state), hn::Set (tag, tile.last ? 1e-200 : 0.0)), state);
}

/** Advances some modes through the tile. */
template <bool single>
HWY_NOINLINE void move (const PlateTile& tile, const Modes& modes)
{
    Vector first[sumsAtOnce], second[sumsAtOnce];

#pragma GCC unroll 16
    for (Index v = 0; v < sumsAtOnce; ++v)
    {
        first[v] = hn::Load (tag, modes.state + v * lanes);
        second[v] = hn::Load (tag, modes.state + groupModes + v * lanes);
    }

    Index sample = 0;

    for (; sample + samplesAtOnce <= tile.samples; sample += samplesAtOnce)
        advance<samplesAtOnce, single> (tile, modes, sample, first, second);

    for (; sample < tile.samples; ++sample)
        advance<1, single> (tile, modes, sample, first, second);

#pragma GCC unroll 16
    for (Index v = 0; v < sumsAtOnce; ++v)
    {
        hn::Store (settled (tile, first[v]), tag, modes.state + v * lanes);
        hn::Store (settled (tile, second[v]), tag, modes.state + groupModes + v * lanes);
    }
}

/** Adds what the modes from one on do at some probes and four samples; the sums of the lanes stay apart. */
template <int probes>
HWY_INLINE void hear (const PlateTile& tile, Index firstMode, Index probe, Index sample)
{
    Vector sums[probes][samplesAtOnce], velocities[samplesAtOnce];
    auto* target = tile.sums + (probe * plateTile + sample) * lanes;

#pragma GCC unroll 16
    for (Index p = 0; p < probes; ++p)
#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
            sums[p][n] = firstMode > 0 ? hn::Load (tag, target + (p * plateTile + n) * lanes) : hn::Zero (tag);

    for (auto mode = firstMode; mode < HWY_MIN (tile.modes, firstMode + plateModesHeard); mode += groupModes)
    {
        const auto modes = modesAt (tile, mode);

#pragma GCC unroll 4
        for (Index v = 0; v < groupModes; v += lanes)
        {
#pragma GCC unroll 16
            for (Index n = 0; n < samplesAtOnce; ++n)
                velocities[n] = hn::Load (tag, modes.motion + (sample + n) * groupModes + v);

#pragma GCC unroll 16
            for (Index p = 0; p < probes; ++p)
            {
                const auto shape = hn::Load (tag, modes.shapes + (probe + p) * groupModes + v);

#pragma GCC unroll 16
                for (Index n = 0; n < samplesAtOnce; ++n)
                    sums[p][n] = hn::MulAdd (shape, velocities[n], sums[p][n]);
            }
        }
    }

#pragma GCC unroll 16
    for (Index p = 0; p < probes; ++p)
#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
            hn::Store (sums[p][n], tag, target + (p * plateTile + n) * lanes);
}

template <int atOnce>
HWY_NOINLINE void hearRows (const PlateTile& tile, Index firstMode, Index probe)
{
    for (; probe + atOnce <= tile.probes; probe += atOnce)
        for (Index sample = 0; sample < tile.samples; sample += samplesAtOnce)
            hear<atOnce> (tile, firstMode, probe, sample);

    if constexpr (atOnce > 1)
        hearRows<atOnce / 2> (tile, firstMode, probe);
}

/** Adds what the modes from one on do at eight probes, which lie in the lanes: so no lanes have to be added up. */
HWY_NOINLINE void hearEight (const PlateTile& tile, Index firstMode, Index probe, Index firstSample)
{
    Vector sums[samplesOfEight][vectorsOfEight];
    auto* target = tile.sums + probe * plateTile * lanes + firstSample * probeGroup;

#pragma GCC unroll 16
    for (Index n = 0; n < samplesOfEight; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < vectorsOfEight; ++v)
            sums[n][v] = firstMode > 0 ? hn::Load (tag, target + n * probeGroup + v * lanes) : hn::Zero (tag);

    for (auto mode = firstMode; mode < HWY_MIN (tile.modes, firstMode + plateModesHeard); mode += groupModes)
    {
        const auto modes = modesAt (tile, mode);
        const auto *shapes = modes.shapes + probe * groupModes, *motion = modes.motion + firstSample * groupModes;

        for (Index k = 0; k < groupModes; ++k)
#pragma GCC unroll 16
            for (Index v = 0; v < vectorsOfEight; ++v)
            {
                const auto shape = hn::Load (tag, shapes + k * probeGroup + v * lanes);

#pragma GCC unroll 16
                for (Index n = 0; n < samplesOfEight; ++n)
                    sums[n][v] = hn::MulAdd (shape, hn::Set (tag, motion[n * groupModes + k]), sums[n][v]);
            }
    }

#pragma GCC unroll 16
    for (Index n = 0; n < samplesOfEight; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < vectorsOfEight; ++v)
            hn::Store (sums[n][v], tag, target + n * probeGroup + v * lanes);
}

/** Adds up the lanes of as many sums as a vector has lanes, in pairs: one vector. */
HWY_INLINE Vector addLanes (const double* sums)
{
    Vector parts[lanes];

#pragma GCC unroll 16
    for (Index i = 0; i < lanes; ++i)
        parts[i] = hn::Load (tag, sums + i * lanes);

#if HWY_TARGET != HWY_SCALAR
#pragma GCC unroll 16
    for (Index left = lanes / 2; left > 0; left /= 2)
#pragma GCC unroll 16
        for (Index i = 0; i < left; ++i)
            parts[i] = hn::Add (hn::ConcatEven (tag, parts[2 * i + 1], parts[2 * i]),
                                hn::ConcatOdd (tag, parts[2 * i + 1], parts[2 * i]));
#endif

    return parts[0];
}

/** Writes as many samples of as many probes as a vector has lanes. Each round takes the lowest bit of the lanes' numbers to the top of
    the vectors' numbers. */
HWY_INLINE void transpose (const double* sums, double* velocities)
{
    Vector from[lanes];

#pragma GCC unroll 16
    for (Index i = 0; i < lanes; ++i)
        from[i] = hn::Load (tag, sums + i * probeGroup);

#if HWY_TARGET != HWY_SCALAR
#pragma GCC unroll 16
    for (Index round = 1; round < lanes; round *= 2)
    {
        Vector to[lanes];

#pragma GCC unroll 16
        for (Index i = 0; i < lanes / 2; ++i)
        {
            to[i] = hn::ConcatEven (tag, from[2 * i + 1], from[2 * i]);
            to[i + lanes / 2] = hn::ConcatOdd (tag, from[2 * i + 1], from[2 * i]);
        }

#pragma GCC unroll 16
        for (Index i = 0; i < lanes; ++i)
            from[i] = to[i];
    }
#endif

#pragma GCC unroll 16
    for (Index i = 0; i < lanes; ++i)
        hn::Store (from[i], tag, velocities + i * plateTile);
}

/** Writes the velocities at all probes. */
HWY_NOINLINE void write (const PlateTile& tile)
{
    const auto eights = tile.probes - tile.probes % probeGroup;

    for (Index p = 0; p < eights; p += lanes)
        for (Index n = 0; n < tile.samples; n += lanes)
            transpose (tile.sums + (p - p % probeGroup) * plateTile * lanes + n * probeGroup + p % probeGroup,
                       tile.velocities + p * plateTile + n);

    for (Index p = eights; p < tile.probes; ++p)
        for (Index n = 0; n < tile.samples; n += lanes)
            hn::Store (addLanes (tile.sums + (p * plateTile + n) * lanes), tag, tile.velocities + p * plateTile + n);
}

/** Adds what the modes from one on do at all probes. */
void hearAll (const PlateTile& tile, Index firstMode)
{
    const auto eights = tile.probes - tile.probes % probeGroup;

    for (Index probe = 0; probe < eights; probe += probeGroup)
        for (Index sample = 0; sample < tile.samples; sample += samplesOfEight)
            hearEight (tile, firstMode, probe, sample);

    hearRows<sumsAtOnce> (tile, firstMode, eights);
}

template <bool single>
void playAs (const PlateTile& tile)
{
    for (Index firstMode = 0; firstMode < tile.modes; firstMode += plateModesHeard)
    {
        const auto endMode = HWY_MIN (tile.modes, firstMode + plateModesHeard);

        for (auto mode = firstMode; mode < endMode; mode += sumsAtOnce * lanes)
            move<single> (tile, modesAt (tile, mode));

        if (! single)
            hearAll (tile, firstMode);
    }
}

void play (const PlateTile& tile)
{
    if (tile.probes == 1)
    {
        for (Index n = 0; n < plateTile; ++n)
            hn::Store (hn::Zero (tag), tag, tile.sums + n * lanes);

        playAs<true> (tile);
    }
    else
    {
        playAs<false> (tile);
    }

    write (tile);
}
} // namespace

PlateKernel playKernel()
{
    return &play;
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (playKernel);
} // namespace

PlateKernel plateKernel()
{
    return HWY_DYNAMIC_DISPATCH (playKernel)();
}
} // namespace antinode
#endif
