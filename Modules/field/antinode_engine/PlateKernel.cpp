#include "PlateKernel.h"

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
constexpr int vectorsAtOnce = HWY_TARGET <= HWY_AVX3 ? 4 : 2; // in addition to the samples: as many forces as registers

/** The forces of some modes at some samples: half of what the voltages add. */
template <int samples>
HWY_INLINE void drive (const PlateTile& tile, const PlateModes& modes, Index sample, Vector (*forces)[vectorsAtOnce])
{
#pragma GCC unroll 16
    for (Index n = 0; n < samples; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
            forces[n][v] = hn::Zero (tag);

    for (Index i = 0; i < tile.ceramics; ++i)
    {
        Vector drive[vectorsAtOnce];

#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
            drive[v] = hn::Load (tag, modes.drive + i * groupModes + v * lanes);

#pragma GCC unroll 16
        for (Index n = 0; n < samples; ++n)
        {
            const auto voltage = hn::Set (tag, tile.voltages[i * plateTile + sample + n]);

#pragma GCC unroll 16
            for (Index v = 0; v < vectorsAtOnce; ++v)
                forces[n][v] = hn::MulAdd (drive[v], voltage, forces[n][v]);
        }
    }
}

/** Advances some modes by some samples; forces and states stay in registers. A single probe is added up here, too. */
template <int samples, bool single>
HWY_INLINE void advance (const PlateTile& tile, const PlateModes& modes, Index sample, Vector* first, Vector* second)
{
    Vector forces[samples][vectorsAtOnce];
    drive<samples> (tile, modes, sample, forces);
    const double *turn = modes.transition, *shapes = modes.shapes; // not reached through what is stored to
    auto* motion = modes.motion + sample * groupModes;
    auto* sums = tile.sums + sample * lanes;

#pragma GCC unroll 16
    for (Index n = 0; n < samples; ++n)
    {
        [[maybe_unused]] auto sum = single && ! modes.first ? hn::Load (tag, sums + n * lanes) : hn::Zero (tag);

#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
        {
            const auto half = forces[n][v];
            const auto velocity =
                hn::MulAdd (hn::Load (tag, turn + v * lanes), first[v],
                            hn::MulAdd (hn::Load (tag, turn + groupModes + v * lanes), second[v], half));
            second[v] = hn::MulAdd (hn::Load (tag, turn + 2 * groupModes + v * lanes), first[v],
                                    hn::Mul (hn::Load (tag, turn + 3 * groupModes + v * lanes), second[v]));
            first[v] = hn::Add (velocity, half);

            if constexpr (single)
                sum = hn::MulAdd (hn::Load (tag, shapes + v * lanes), velocity, sum);
            else
                hn::Store (velocity, tag, motion + n * groupModes + v * lanes);
        }

        if constexpr (single)
            hn::Store (sum, tag, sums + n * lanes);
    }
}

/** One ceramic and one probe: the registers hold what the modes are instead of forces. */
HWY_INLINE void advanceBank (const PlateTile& tile, const PlateModes& modes, Vector* first, Vector* second)
{
    Vector turn[4][vectorsAtOnce];
    const double *drive = modes.drive, *shapes = modes.shapes, *voltages = tile.voltages;
    auto* sums = tile.sums;
    const Index samples = tile.samples;

#pragma GCC unroll 16
    for (Index k = 0; k < 4; ++k)
#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
            turn[k][v] = hn::Load (tag, modes.transition + k * groupModes + v * lanes);

    for (Index n = 0; n < samples; ++n)
    {
        const auto voltage = hn::Set (tag, voltages[n]);
        auto sum = modes.first ? hn::Zero (tag) : hn::Load (tag, sums + n * lanes);

#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
        {
            const auto half = hn::Mul (hn::Load (tag, drive + v * lanes), voltage);
            const auto velocity = hn::MulAdd (turn[0][v], first[v], hn::MulAdd (turn[1][v], second[v], half));
            second[v] = hn::MulAdd (turn[2][v], first[v], hn::Mul (turn[3][v], second[v]));
            first[v] = hn::Add (velocity, half);
            sum = hn::MulAdd (hn::Load (tag, shapes + v * lanes), velocity, sum);
        }

        hn::Store (sum, tag, sums + n * lanes);
    }
}

/** Advances some modes, sample by sample where four are too many. */
template <bool single>
HWY_INLINE void advanceAll (const PlateTile& tile, const PlateModes& modes, Vector* first, Vector* second)
{
    Index sample = 0;

    for (; sample + samplesAtOnce <= tile.samples; sample += samplesAtOnce)
        advance<samplesAtOnce, single> (tile, modes, sample, first, second);

    for (; sample < tile.samples; ++sample)
        advance<1, single> (tile, modes, sample, first, second);
}

/** Advances complex modes by some samples. The forces on the first coordinates wait where their velocities will be. A
   single probe is added up here, too. */
template <int samples, bool single>
HWY_INLINE void advanceComplex (const PlateTile& tile, const PlateModes& modes, Index sample, Vector* first,
                                Vector* second)
{
    Vector forces[samples][vectorsAtOnce];
    const double *turn = modes.transition, *shapes = modes.shapes;
    auto* motion = modes.motion + sample * groupModes;
    auto* turned = motion + groupModes * plateTile;
    auto* sums = tile.sums + sample * lanes;
    drive<samples> (tile, modes, sample, forces);

#pragma GCC unroll 16
    for (Index n = 0; n < samples; ++n)
#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
            hn::Store (forces[n][v], tag, motion + n * groupModes + v * lanes);

    auto ofSecond = modes;
    ofSecond.drive += groupModes * tile.ceramics;
    drive<samples> (tile, ofSecond, sample, forces);

#pragma GCC unroll 16
    for (Index n = 0; n < samples; ++n)
    {
        [[maybe_unused]] auto sum = single && ! modes.first ? hn::Load (tag, sums + n * lanes) : hn::Zero (tag);

#pragma GCC unroll 16
        for (Index v = 0; v < vectorsAtOnce; ++v)
        {
            const auto half = hn::Load (tag, motion + n * groupModes + v * lanes);
            const auto velocity =
                hn::MulAdd (hn::Load (tag, turn + v * lanes), first[v],
                            hn::MulAdd (hn::Load (tag, turn + groupModes + v * lanes), second[v], half));
            const auto other =
                hn::MulAdd (hn::Load (tag, turn + 2 * groupModes + v * lanes), first[v],
                            hn::MulAdd (hn::Load (tag, turn + 3 * groupModes + v * lanes), second[v], forces[n][v]));
            first[v] = hn::Add (velocity, half);
            second[v] = hn::Add (other, forces[n][v]);

            if constexpr (single)
            {
                sum = hn::MulAdd (hn::Load (tag, shapes + v * lanes), velocity, sum);
                sum = hn::MulAdd (hn::Load (tag, shapes + groupModes + v * lanes), other, sum);
            }
            else
            {
                hn::Store (velocity, tag, motion + n * groupModes + v * lanes);
                hn::Store (other, tag, turned + n * groupModes + v * lanes);
            }
        }

        if constexpr (single)
            hn::Store (sum, tag, sums + n * lanes);
    }
}

/** Advances some complex modes, sample by sample where four are too many. */
template <bool single>
HWY_INLINE void advanceAllComplex (const PlateTile& tile, const PlateModes& modes, Vector* first, Vector* second)
{
    Index sample = 0;

    for (; sample + samplesAtOnce <= tile.samples; sample += samplesAtOnce)
        advanceComplex<samplesAtOnce, single> (tile, modes, sample, first, second);

    for (; sample < tile.samples; ++sample)
        advanceComplex<1, single> (tile, modes, sample, first, second);
}

enum class Kind
{
    many, // probes
    single,
    bank, // and one ceramic
    complexModes,
    singleComplex
};

/** States below 1e-200 become 0 where a tile ends. */
HWY_INLINE Vector settled (const PlateTile& tile, Vector state)
{
    return hn::IfThenElseZero (hn::Ge (hn::Abs (state), hn::Set (tag, tile.last ? 1e-200 : 0.0)), state);
}

/** Advances some modes through the tile. */
template <Kind kind>
HWY_NOINLINE void moveSome (const PlateTile& tile, const PlateModes& modes)
{
    Vector first[vectorsAtOnce], second[vectorsAtOnce];

#pragma GCC unroll 16
    for (Index v = 0; v < vectorsAtOnce; ++v)
    {
        first[v] = hn::Load (tag, modes.state + v * lanes);
        second[v] = hn::Load (tag, modes.state + groupModes + v * lanes);
    }

    if constexpr (kind == Kind::bank)
        advanceBank (tile, modes, first, second);
    else if constexpr (kind == Kind::complexModes || kind == Kind::singleComplex)
        advanceAllComplex<kind == Kind::singleComplex> (tile, modes, first, second);
    else
        advanceAll<kind == Kind::single> (tile, modes, first, second);

#pragma GCC unroll 16
    for (Index v = 0; v < vectorsAtOnce; ++v)
    {
        hn::Store (settled (tile, first[v]), tag, modes.state + v * lanes);
        hn::Store (settled (tile, second[v]), tag, modes.state + groupModes + v * lanes);
    }
}

template <Kind kind>
void moveAll (const PlateTile& tile, Index firstMode)
{
    for (auto mode = firstMode; mode < plateModesEnd (tile, firstMode); mode += vectorsAtOnce * lanes)
        moveSome<kind> (tile, plateModes (tile, mode));
}

/** Of complex modes every other group is the second coordinates of the one before it. */
template <Kind kind>
void moveAllComplex (const PlateTile& tile, Index firstMode)
{
    for (auto group = firstMode; group < plateModesEnd (tile, firstMode); group += 2 * groupModes)
        for (auto mode = group; mode < group + groupModes; mode += vectorsAtOnce * lanes)
            moveSome<kind> (tile, plateComplexModes (tile, mode));
}

void move (const PlateTile& tile, Index firstMode)
{
    if (tile.complex && tile.probes == 1)
        moveAllComplex<Kind::singleComplex> (tile, firstMode);
    else if (tile.complex)
        moveAllComplex<Kind::complexModes> (tile, firstMode);
    else if (tile.probes != 1)
        moveAll<Kind::many> (tile, firstMode);
    else if (tile.ceramics != 1)
        moveAll<Kind::single> (tile, firstMode);
    else
        moveAll<Kind::bank> (tile, firstMode);
}
} // namespace

PlateKernel moveKernel()
{
    return &move;
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (moveKernel);
} // namespace

PlateKernel plateKernel()
{
    return HWY_DYNAMIC_DISPATCH (moveKernel)();
}
} // namespace antinode
#endif
