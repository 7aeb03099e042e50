#include "SynthesisKernel.h"

#include <algorithm>
#include <array>
#include <utility>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/SynthesisKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

// Blocks of ceramics x vectors of sums: as many as the registers hold in addition to the factors. Two units with a
// latency of four cycles need eight.
constexpr int maximumCeramics = HWY_TARGET <= HWY_AVX3 ? 8 : 4;
constexpr int vectors = 2;

constexpr hn::ScalableTag<double> tag;
using Vector = hn::VFromD<hn::ScalableTag<double>>;
constexpr int lanes = static_cast<int> (hn::MaxLanes (tag));
constexpr int blockSamples = vectors * lanes;
static_assert (synthesisTile % blockSamples == 0);

enum class Source
{
    phasors,
    values
};

/** The values of an oscillation in the block that begins at a sample of the strip. */
HWY_INLINE void evaluateBlock (const double* phasors, const double* fine, int sample, Vector* values)
{
    const auto* phasor = phasors + sample / synthesisTile;
    const auto real = hn::Set (tag, phasor[0]), imaginary = hn::Set (tag, phasor[synthesisStrip]);
    fine += sample % synthesisTile;

#pragma GCC unroll 16
    for (int v = 0; v < vectors; ++v)
        values[v] = hn::NegMulAdd (imaginary, hn::Load (tag, fine + synthesisTile + v * lanes),
                                   hn::Mul (real, hn::Load (tag, fine + v * lanes)));
}

/** Computes the values of a block and keeps them for more ceramics, or takes what was kept. */
template <Source source>
HWY_INLINE void findValues (const double* phasors, const double* record, int sample, double* kept, Vector* values)
{
    if constexpr (source == Source::phasors)
        evaluateBlock (phasors, record, sample, values);

#pragma GCC unroll 16
    for (int v = 0; v < vectors; ++v)
        if constexpr (source == Source::phasors)
            hn::Store (values[v], tag, kept + v * lanes);
        else
            values[v] = hn::Load (tag, kept + v * lanes);
}

/** The same pointer, of which the compiler knows nothing. Otherwise g++ keeps an offset for each ceramic in a register
   of its own, and saves and restores them with each block: 3 points of the limit. */
HWY_INLINE const double* opaque (const double* pointer)
{
    asm("" : "+r"(pointer));
    return pointer;
}

/** Adds a block, whose sums stay in registers. Its first sample lies at channels[i][offset]. */
template <int ceramics, Source source>
HWY_NOINLINE void addBlock (SynthesisChunk& chunk, int sample, int firstCeramic, double* const* channels,
                            std::ptrdiff_t offset)
{
    Vector sums[ceramics][vectors], values[vectors];

#pragma GCC unroll 16
    for (int i = 0; i < ceramics; ++i)
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            sums[i][v] = hn::LoadU (tag, channels[i] + offset + v * lanes);

    const auto* phasors = chunk.phasors;
    auto* kept = chunk.values + sample % synthesisTile;
    const double *const *record = chunk.records, *const *const end = record + chunk.count;

    for (; record < end; ++record, phasors += 2 * synthesisStrip, kept += synthesisTile)
    {
        findValues<source> (phasors, *record, sample, kept, values);
        const auto* mixing = opaque (*record + firstCeramic);

#pragma GCC unroll 16
        for (int i = 0; i < ceramics; ++i)
        {
            const auto weight = hn::Set (tag, mixing[2 * synthesisTile + i]);

#pragma GCC unroll 16
            for (int v = 0; v < vectors; ++v)
                sums[i][v] = hn::MulAdd (weight, values[v], sums[i][v]);
        }
    }

#pragma GCC unroll 16
    for (int i = 0; i < ceramics; ++i)
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            hn::StoreU (sums[i][v], tag, channels[i] + offset + v * lanes);
}

using AddBlock = void (*) (SynthesisChunk&, int sample, int firstCeramic, double* const* channels,
                           std::ptrdiff_t offset);

/** The forms of addBlock for 1, 2, ... ceramics. */
template <Source source, int... counts>
constexpr std::array<AddBlock, sizeof...(counts)> makeBlocks (std::integer_sequence<int, counts...>)
{
    return { &addBlock<counts + 1, source>... };
}

/** Adds the part begin .. end - 1 of a block to copies, since the neighbouring samples belong to others. */
HWY_NOINLINE void addPart (AddBlock add, SynthesisChunk& chunk, const SynthesisTarget& target, int sample, int i)
{
    const auto ceramics = std::min (maximumCeramics, target.ceramics - i);
    const auto begin = std::max (sample, target.begin), end = std::min (sample + blockSamples, target.end);
    double copies[maximumCeramics][blockSamples] = {};
    double* pointers[maximumCeramics] = {};

    for (int k = 0; k < ceramics; ++k)
    {
        pointers[k] = copies[k];
        std::copy_n (target.channels[i + k] + target.offset + begin, end - begin, copies[k] + (begin - sample));
    }

    add (chunk, sample, target.firstCeramic + i, pointers, 0);

    for (int k = 0; k < ceramics; ++k)
        std::copy_n (copies[k] + (begin - sample), end - begin, target.channels[i + k] + target.offset + begin);
}

/** Adds a block to the ceramics from i on, as many as go at once. */
template <Source source>
HWY_INLINE void addGroup (SynthesisChunk& chunk, const SynthesisTarget& target, int sample, int i)
{
    static constexpr auto blocks = makeBlocks<source> (std::make_integer_sequence<int, maximumCeramics>());
    const auto add = blocks[static_cast<std::size_t> (std::min (maximumCeramics, target.ceramics - i) - 1)];

    if (sample >= target.begin && sample + blockSamples <= target.end)
        add (chunk, sample, target.firstCeramic + i, target.channels + i, target.offset + sample);
    else
        addPart (add, chunk, target, sample, i);
}

/** Adds a strip block by block. Each value is computed once. */
template <Source source>
void addBlocks (SynthesisChunk& chunk, const SynthesisTarget& target)
{
    for (auto sample = target.begin - target.begin % blockSamples; sample < target.end; sample += blockSamples)
    {
        addGroup<source> (chunk, target, sample, 0);

        for (auto i = maximumCeramics; i < target.ceramics; i += maximumCeramics)
            addGroup<Source::values> (chunk, target, sample, i);
    }
}

void evaluate (SynthesisChunk& chunk, int tile)
{
    Vector values[vectors];

    for (int c = 0; c < chunk.count; ++c)
        for (int within = 0; within < synthesisTile; within += blockSamples)
            findValues<Source::phasors> (chunk.phasors + c * 2 * synthesisStrip, chunk.records[c],
                                         tile * synthesisTile + within, chunk.values + c * synthesisTile + within,
                                         values);
}
} // namespace

SynthesisKernel synthesisKernelOfTarget()
{
    return { &addBlocks<Source::phasors>, &evaluate, &addBlocks<Source::values> };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (synthesisKernelOfTarget);
} // namespace

SynthesisKernel synthesisKernel()
{
    return HWY_DYNAMIC_DISPATCH (synthesisKernelOfTarget)();
}
} // namespace antinode
#endif
