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
constexpr int groupVectors = 4; // so many modes at a time hide the latency of the recursion
constexpr Index groupModes = groupVectors * lanes;
constexpr int samplesAtOnce = 4;
constexpr int sumsAtOnce = HWY_TARGET <= HWY_AVX3 ? 4 : 2; // beside the samples: as many sums as there are registers

/** The forces of some modes at four samples: half of what the voltages add. */
template <int vectors>
HWY_INLINE void driveBlock (const PlateTile& tile, Index mode, Index sample, double* motion)
{
    Vector sums[samplesAtOnce][vectors], drive[vectors];

#pragma GCC unroll 16
    for (Index n = 0; n < samplesAtOnce; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < vectors; ++v)
            sums[n][v] = hn::Zero (tag);

    for (Index i = 0; i < tile.ceramics; ++i)
    {
#pragma GCC unroll 16
        for (Index v = 0; v < vectors; ++v)
            drive[v] = hn::Load (tag, tile.drive + i * tile.modes + mode + v * lanes);

#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
        {
            const auto voltage = hn::Set (tag, tile.voltages[i * plateTile + sample + n]);

#pragma GCC unroll 16
            for (Index v = 0; v < vectors; ++v)
                sums[n][v] = hn::MulAdd (drive[v], voltage, sums[n][v]);
        }
    }

#pragma GCC unroll 16
    for (Index n = 0; n < samplesAtOnce; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < vectors; ++v)
            hn::Store (sums[n][v], tag, motion + (sample + n) * groupModes + v * lanes);
}

HWY_NOINLINE void drive (const PlateTile& tile, Index mode)
{
    for (Index sample = 0; sample < tile.samples; sample += samplesAtOnce)
        for (Index v = 0; v < groupVectors; v += sumsAtOnce)
            driveBlock<sumsAtOnce> (tile, mode + v * lanes, sample, tile.motion + v * lanes);
}

/** Puts velocities in the place of forces, sample by sample. */
HWY_NOINLINE void advance (const PlateTile& tile, Index mode)
{
    Vector first[groupVectors], second[groupVectors], transition[4][groupVectors];

#pragma GCC unroll 16
    for (Index v = 0; v < groupVectors; ++v)
    {
        first[v] = hn::Load (tag, tile.state + mode + v * lanes);
        second[v] = hn::Load (tag, tile.state + tile.modes + mode + v * lanes);
#pragma GCC unroll 16
        for (Index k = 0; k < 4; ++k)
            transition[k][v] = hn::Load (tag, tile.transition + k * tile.modes + mode + v * lanes);
    }

    for (Index n = 0; n < tile.samples; ++n)
    {
#pragma GCC unroll 16
        for (Index v = 0; v < groupVectors; ++v)
        {
            auto* motion = tile.motion + n * groupModes + v * lanes;
            const auto half = hn::Load (tag, motion);
            const auto velocity =
                hn::MulAdd (transition[0][v], first[v], hn::MulAdd (transition[1][v], second[v], half));
            second[v] = hn::MulAdd (transition[2][v], first[v], hn::Mul (transition[3][v], second[v]));
            first[v] = hn::Add (velocity, half);
            hn::Store (velocity, tag, motion);
        }
    }

    const auto least = hn::Set (tag, tile.last ? 1e-200 : 0.0);

#pragma GCC unroll 16
    for (Index v = 0; v < groupVectors; ++v)
    {
        const auto keepFirst = hn::Ge (hn::Abs (first[v]), least), keepSecond = hn::Ge (hn::Abs (second[v]), least);
        hn::Store (hn::IfThenElseZero (keepFirst, first[v]), tag, tile.state + mode + v * lanes);
        hn::Store (hn::IfThenElseZero (keepSecond, second[v]), tag, tile.state + tile.modes + mode + v * lanes);
    }
}

/** Adds what a group of modes does at some probes and four samples; the sums of the lanes stay apart. */
template <int probes>
HWY_INLINE void probeBlock (const PlateTile& tile, Index mode, Index probe, Index sample)
{
    Vector sums[probes][samplesAtOnce], velocities[samplesAtOnce];
    auto* target = tile.sums + (probe * plateTile + sample) * lanes;

#pragma GCC unroll 16
    for (Index p = 0; p < probes; ++p)
#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
            sums[p][n] = mode > 0 ? hn::Load (tag, target + (p * plateTile + n) * lanes) : hn::Zero (tag);

#pragma GCC unroll 16
    for (Index v = 0; v < groupVectors; ++v)
    {
#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
            velocities[n] = hn::Load (tag, tile.motion + (sample + n) * groupModes + v * lanes);

#pragma GCC unroll 16
        for (Index p = 0; p < probes; ++p)
        {
            const auto shape = hn::Load (tag, tile.shapes + (probe + p) * tile.modes + mode + v * lanes);

#pragma GCC unroll 16
            for (Index n = 0; n < samplesAtOnce; ++n)
                sums[p][n] = hn::MulAdd (shape, velocities[n], sums[p][n]);
        }
    }

#pragma GCC unroll 16
    for (Index p = 0; p < probes; ++p)
#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
            hn::Store (sums[p][n], tag, target + (p * plateTile + n) * lanes);
}

template <int atOnce>
HWY_NOINLINE void probe (const PlateTile& tile, Index mode, Index firstProbe)
{
    for (; firstProbe + atOnce <= tile.probes; firstProbe += atOnce)
        for (Index sample = 0; sample < tile.samples; sample += samplesAtOnce)
            probeBlock<atOnce> (tile, mode, firstProbe, sample);

    if constexpr (atOnce > 1)
        probe<atOnce / 2> (tile, mode, firstProbe);
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

void play (const PlateTile& tile)
{
    for (Index mode = 0; mode < tile.modes; mode += groupModes)
    {
        drive (tile, mode);
        advance (tile, mode);
        probe<sumsAtOnce> (tile, mode, 0);
    }

    for (Index p = 0; p < tile.probes; ++p)
        for (Index n = 0; n < tile.samples; n += lanes)
            hn::Store (addLanes (tile.sums + (p * plateTile + n) * lanes), tag, tile.velocities + p * plateTile + n);
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
