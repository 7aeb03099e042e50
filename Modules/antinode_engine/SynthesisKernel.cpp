#include "SynthesisKernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// As many sums as the registers hold beside what is multiplied. Two units with a latency of four cycles need eight.
constexpr int registerSums = HWY_TARGET <= HWY_AVX3 ? 16 : 8;
constexpr int mostCeramics = HWY_TARGET <= HWY_AVX3 ? 8 : 4;

template <typename Sample>
constexpr int lanes = static_cast<int> (hn::MaxLanes (hn::ScalableTag<Sample>()));

/** One oscillation in as many tiles of 64 samples, whose table is read once. */
template <int tiles, typename Sample>
HWY_INLINE void evaluateOne (const SoundingOscillation<Sample>& oscillation, int tile, Sample* values)
{
    constexpr auto least =
        static_cast<double> (std::numeric_limits<Sample>::min() / std::numeric_limits<Sample>::epsilon());
    const hn::ScalableTag<Sample> tag;
    hn::VFromD<decltype (tag)> real[tiles], imaginary[tiles];

#pragma GCC unroll 4
    for (int t = 0; t < tiles; ++t)
    {
        const auto phasor = product (oscillation.anchor, oscillation.turns[tile + t]);
        const auto audible = std::abs (phasor.real()) + std::abs (phasor.imag()) >= least;
        real[t] = hn::Set (tag, audible ? static_cast<Sample> (phasor.real()) : Sample (0));
        imaginary[t] = hn::Set (tag, audible ? static_cast<Sample> (phasor.imag()) : Sample (0));
    }

#pragma GCC unroll 8
    for (int j = 0; j < synthesisTile; j += lanes<Sample>)
    {
        const auto fineReal = hn::Load (tag, oscillation.fine + j);
        const auto fineImaginary = hn::Load (tag, oscillation.fine + synthesisTile + j);

#pragma GCC unroll 4
        for (int t = 0; t < tiles; ++t)
            hn::Store (hn::NegMulAdd (imaginary[t], fineImaginary, hn::Mul (real[t], fineReal)), tag,
                       values + t * synthesisTile + j);
    }
}

template <typename Sample>
void evaluate (SynthesisChunk<Sample>& chunk, int tile, int tiles)
{
    for (int c = 0; c < chunk.count; ++c)
        if (auto* values = chunk.values + c * chunk.samples; tiles == synthesisStrip)
            evaluateOne<synthesisStrip> (chunk.sounding[c], tile, values);
        else
            evaluateOne<1> (chunk.sounding[c], tile, values);
}

/** Mixes a block of ceramics x vectors, whose sums stay in registers. @param targets  where its first sample lies */
template <int ceramics, int vectors, typename Sample>
HWY_NOINLINE void mixBlock (const SynthesisChunk<Sample>& chunk, int sample, int firstCeramic, Sample* const* targets)
{
    const hn::ScalableTag<Sample> tag;
    hn::VFromD<decltype (tag)> sums[ceramics][vectors], values[vectors];

#pragma GCC unroll 16
    for (int i = 0; i < ceramics; ++i)
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            sums[i][v] = hn::LoadU (tag, targets[i] + v * lanes<Sample>);

    for (int c = 0; c < chunk.count; ++c)
    {
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            values[v] = hn::Load (tag, chunk.values + c * chunk.samples + sample + v * lanes<Sample>);

#pragma GCC unroll 16
        for (int i = 0; i < ceramics; ++i)
        {
            const auto mixing = hn::Set (tag, chunk.sounding[c].mixing[firstCeramic + i]);

#pragma GCC unroll 16
            for (int v = 0; v < vectors; ++v)
                sums[i][v] = hn::MulAdd (mixing, values[v], sums[i][v]);
        }
    }

#pragma GCC unroll 16
    for (int i = 0; i < ceramics; ++i)
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            hn::StoreU (sums[i][v], tag, targets[i] + v * lanes<Sample>);
}

/** Mixes the samples begin .. end - 1 of one vector, in a copy: beside them lies what is not ours. */
template <int ceramics, typename Sample>
HWY_NOINLINE void mixPart (const SynthesisChunk<Sample>& chunk, int begin, int end, int firstCeramic,
                           Sample* const* targets)
{
    Sample copies[ceramics][lanes<Sample>] = {};
    Sample* pointers[ceramics];
    const auto skipped = begin % lanes<Sample>;

    for (int i = 0; i < ceramics; ++i)
    {
        pointers[i] = copies[i];
        std::copy_n (targets[i], end - begin, copies[i] + skipped);
    }

    mixBlock<ceramics, 1> (chunk, begin - skipped, firstCeramic, pointers);

    for (int i = 0; i < ceramics; ++i)
        std::copy_n (copies[i] + skipped, end - begin, targets[i]);
}

/** Mixes to a group of ceramics: as many vectors at a time as there are registers, then one, then parts. */
template <int ceramics, typename Sample>
void mixGroup (const SynthesisChunk<Sample>& chunk, int begin, int end, int firstCeramic, Sample* const* channels,
               std::ptrdiff_t offset)
{
    constexpr int most = std::min (registerSums / ceramics, synthesisTile / lanes<Sample>) * lanes<Sample>;
    Sample* targets[ceramics];

    for (int sample = begin, step = 0; sample < end; sample += step)
    {
        const auto misplaced = sample % lanes<Sample>;
        step = misplaced == 0 && sample + most <= end ? most : std::min (lanes<Sample> - misplaced, end - sample);

        for (int i = 0; i < ceramics; ++i)
            targets[i] = channels[firstCeramic + i] + offset + (sample - begin);

        if (step == most)
            mixBlock<ceramics, most / lanes<Sample>> (chunk, sample, firstCeramic, targets);
        else if (step == lanes<Sample>)
            mixBlock<ceramics, 1> (chunk, sample, firstCeramic, targets);
        else
            mixPart<ceramics> (chunk, sample, sample + step, firstCeramic, targets);
    }
}

/** Mixes to the ceramics from firstCeramic on, as many at a time as the template says, then fewer. */
template <int atOnce, typename Sample>
void mixCeramics (const SynthesisChunk<Sample>& chunk, int begin, int end, int firstCeramic, int ceramics,
                  Sample* const* channels, std::ptrdiff_t offset)
{
    for (; firstCeramic + atOnce <= ceramics; firstCeramic += atOnce)
        mixGroup<atOnce> (chunk, begin, end, firstCeramic, channels, offset);

    if constexpr (atOnce > 1)
        mixCeramics<atOnce / 2> (chunk, begin, end, firstCeramic, ceramics, channels, offset);
}

template <typename Sample>
void mix (const SynthesisChunk<Sample>& chunk, int begin, int end, int ceramics, Sample* const* channels,
          std::ptrdiff_t offset)
{
    mixCeramics<mostCeramics> (chunk, begin, end, 0, ceramics, channels, offset);
}
} // namespace

SynthesisKernel<double> doubleSynthesisKernel()
{
    return { &evaluate<double>, &mix<double> };
}

SynthesisKernel<float> floatSynthesisKernel()
{
    return { &evaluate<float>, &mix<float> };
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
