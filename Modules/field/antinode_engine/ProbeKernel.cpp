#include "ProbeKernel.h"

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/ProbeKernel.cpp"
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
constexpr Index groupModes = plateModeGroup, probeGroup = plateProbeGroup;
constexpr int samplesAtOnce = 4;
constexpr int registerSums = HWY_TARGET <= HWY_AVX3 ? 16 : 8; // in addition to the factors
constexpr int rowsAtOnce = registerSums / samplesAtOnce;
constexpr Index vectorsOfEight = probeGroup / lanes, samplesOfEight = registerSums / vectorsOfEight;

/** Adds what the modes from one on do at some probes and four samples; the sums of the lanes stay apart. */
template <int probes>
HWY_INLINE void hearBlock (const PlateTile& tile, Index firstMode, Index probe, Index sample)
{
    Vector sums[probes][samplesAtOnce], velocities[samplesAtOnce];
    auto* target = tile.sums + (probe * plateTile + sample) * lanes;

#pragma GCC unroll 16
    for (Index p = 0; p < probes; ++p)
#pragma GCC unroll 16
        for (Index n = 0; n < samplesAtOnce; ++n)
            sums[p][n] = firstMode > 0 ? hn::Load (tag, target + (p * plateTile + n) * lanes) : hn::Zero (tag);

    for (auto mode = firstMode; mode < plateModesEnd (tile, firstMode); mode += groupModes)
    {
        const auto modes = plateModes (tile, mode);

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
            hearBlock<atOnce> (tile, firstMode, probe, sample);

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

    for (auto mode = firstMode; mode < plateModesEnd (tile, firstMode); mode += groupModes)
    {
        const auto modes = plateModes (tile, mode);
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

/** Writes as many samples of as many probes as a vector has lanes. Each round takes the lowest bit of the lanes'
   numbers to the top of the vectors' numbers. */
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

/** Adds what the modes from one on do at all probes; a single one has been added up already. */
void hear (const PlateTile& tile, Index firstMode)
{
    const auto eights = tile.probes - tile.probes % probeGroup;

    for (Index probe = 0; probe < eights; probe += probeGroup)
        for (Index sample = 0; sample < tile.samples; sample += samplesOfEight)
            hearEight (tile, firstMode, probe, sample);

    if (tile.probes > 1)
        hearRows<rowsAtOnce> (tile, firstMode, eights);
}
} // namespace

ProbeKernel hearKernel()
{
    return { &hear, &write };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (hearKernel);
} // namespace

ProbeKernel probeKernel()
{
    return HWY_DYNAMIC_DISPATCH (hearKernel)();
}
} // namespace antinode
#endif
