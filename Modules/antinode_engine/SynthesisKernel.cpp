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

template <typename Sample>
constexpr int lanes = static_cast<int> (hn::MaxLanes (hn::ScalableTag<Sample>()));

template <typename Sample>
constexpr int blockSamples = vectors* lanes<Sample>;

template <typename Sample>
constexpr int tilesOfBlock = std::max (1, blockSamples<Sample> / synthesisTile);

template <typename Sample>
using VectorOf = hn::VFromD<hn::ScalableTag<Sample>>;

enum class Source
{
    phasors,
    values
};

/** The values of an oscillation in the block that begins at a sample of the strip. */
template <typename Sample>
HWY_INLINE void evaluateBlock (const Sample* phasors, const Sample* fine, int sample, VectorOf<Sample>* values)
{
    const hn::ScalableTag<Sample> tag;
    VectorOf<Sample> real[tilesOfBlock<Sample>], imaginary[tilesOfBlock<Sample>];
    const auto* phasor = phasors + sample / synthesisTile;
    fine += sample % synthesisTile;

#pragma GCC unroll 16
    for (int t = 0; t < tilesOfBlock<Sample>; ++t)
    {
        real[t] = hn::Set (tag, phasor[t]);
        imaginary[t] = hn::Set (tag, phasor[synthesisStrip + t]);
    }

#pragma GCC unroll 16
    for (int v = 0; v < vectors; ++v)
    {
        const auto tile = v * lanes<Sample> / synthesisTile, within = v * lanes<Sample> % synthesisTile;
        values[v] = hn::NegMulAdd (imaginary[tile], hn::Load (tag, fine + synthesisTile + within),
                                   hn::Mul (real[tile], hn::Load (tag, fine + within)));
    }
}

/** Computes the values of a block and keeps them for more ceramics, or takes what was kept. */
template <Source source, typename Sample>
HWY_INLINE void findValues (const Sample* phasors, const Sample* record, int sample, Sample* kept,
                            VectorOf<Sample>* values)
{
    const hn::ScalableTag<Sample> tag;

    if constexpr (source == Source::phasors)
        evaluateBlock (phasors, record, sample, values);

#pragma GCC unroll 16
    for (int v = 0; v < vectors; ++v)
        if constexpr (source == Source::phasors)
            hn::Store (values[v], tag, kept + v * lanes<Sample>);
        else
            values[v] = hn::Load (tag, kept + v * lanes<Sample>);
}

/** The same pointer, of which the compiler knows nothing. Otherwise g++ keeps an offset for each ceramic in a register
   of its own, and saves and restores them with each block: 3 points of the limit. */
template <typename Sample>
HWY_INLINE const Sample* opaque (const Sample* pointer)
{
    asm("" : "+r"(pointer));
    return pointer;
}

/** Adds a block, whose sums stay in registers. Its first sample lies at channels[i][offset]. */
template <int ceramics, Source source, typename Sample>
HWY_NOINLINE void addBlock (SynthesisChunk<Sample>& chunk, int sample, int firstCeramic, Sample* const* channels,
                            std::ptrdiff_t offset)
{
    const hn::ScalableTag<Sample> tag;
    VectorOf<Sample> sums[ceramics][vectors], values[vectors];

#pragma GCC unroll 16
    for (int i = 0; i < ceramics; ++i)
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            sums[i][v] = hn::LoadU (tag, channels[i] + offset + v * lanes<Sample>);

    const auto* phasors = chunk.phasors;
    auto* kept = chunk.values + sample % chunk.span;
    const Sample *const *record = chunk.records, *const *const end = record + chunk.count;

    for (; record < end; ++record, phasors += 2 * synthesisStrip, kept += chunk.span)
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
            hn::StoreU (sums[i][v], tag, channels[i] + offset + v * lanes<Sample>);
}

template <typename Sample>
using AddBlock = void (*) (SynthesisChunk<Sample>&, int sample, int firstCeramic, Sample* const* channels,
                           std::ptrdiff_t offset);

/** The forms of addBlock for 1, 2, ... ceramics. */
template <Source source, typename Sample, int... counts>
constexpr std::array<AddBlock<Sample>, sizeof...(counts)> makeBlocks (std::integer_sequence<int, counts...>)
{
    return { &addBlock<counts + 1, source, Sample>... };
}

/** Adds the part begin .. end - 1 of a block to copies, since the neighbouring samples belong to others. */
template <typename Sample>
HWY_NOINLINE void addPart (AddBlock<Sample> add, SynthesisChunk<Sample>& chunk, const SynthesisTarget<Sample>& target,
                           int sample, int i)
{
    const auto ceramics = std::min (maximumCeramics, target.ceramics - i);
    const auto begin = std::max (sample, target.begin), end = std::min (sample + blockSamples<Sample>, target.end);
    Sample copies[maximumCeramics][blockSamples<Sample>] = {};
    Sample* pointers[maximumCeramics] = {};

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
template <Source source, typename Sample>
HWY_INLINE void addGroup (SynthesisChunk<Sample>& chunk, const SynthesisTarget<Sample>& target, int sample, int i)
{
    static constexpr auto blocks = makeBlocks<source, Sample> (std::make_integer_sequence<int, maximumCeramics>());
    const auto add = blocks[static_cast<std::size_t> (std::min (maximumCeramics, target.ceramics - i) - 1)];

    if (sample >= target.begin && sample + blockSamples<Sample> <= target.end)
        add (chunk, sample, target.firstCeramic + i, target.channels + i, target.offset + sample);
    else
        addPart (add, chunk, target, sample, i);
}

/** Adds a strip block by block. Each value is computed once. */
template <Source source, typename Sample>
void addBlocks (SynthesisChunk<Sample>& chunk, const SynthesisTarget<Sample>& target)
{
    for (auto sample = target.begin - target.begin % blockSamples<Sample>; sample < target.end;
         sample += blockSamples<Sample>)
    {
        addGroup<source> (chunk, target, sample, 0);

        for (auto i = maximumCeramics; i < target.ceramics; i += maximumCeramics)
            addGroup<Source::values> (chunk, target, sample, i);
    }
}

template <typename Sample>
void evaluate (SynthesisChunk<Sample>& chunk, int tile)
{
    VectorOf<Sample> values[vectors];
    const auto first = tile * synthesisTile - tile * synthesisTile % blockSamples<Sample>;

    for (int c = 0; c < chunk.count; ++c)
        for (auto sample = first; sample < (tile + 1) * synthesisTile; sample += blockSamples<Sample>)
            findValues<Source::phasors> (chunk.phasors + c * 2 * synthesisStrip, chunk.records[c], sample,
                                         chunk.values + c * chunk.span + sample % chunk.span, values);
}
} // namespace

SynthesisKernel<double> doubleSynthesisKernel()
{
    return { &addBlocks<Source::phasors, double>, &evaluate<double>, &addBlocks<Source::values, double> };
}

SynthesisKernel<float> floatSynthesisKernel()
{
    return { &addBlocks<Source::phasors, float>, &evaluate<float>, &addBlocks<Source::values, float> };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (doubleSynthesisKernel);
HWY_EXPORT (floatSynthesisKernel);
} // namespace

template <>
SynthesisKernel<double> synthesisKernel<double>()
{
    return HWY_DYNAMIC_DISPATCH (doubleSynthesisKernel)();
}

template <>
SynthesisKernel<float> synthesisKernel<float>()
{
    return HWY_DYNAMIC_DISPATCH (floatSynthesisKernel)();
}
} // namespace antinode
#endif
