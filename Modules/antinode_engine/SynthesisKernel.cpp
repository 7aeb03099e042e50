#include "SynthesisKernel.h"

#include <algorithm>
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

template <typename Tag, typename Vector>
HWY_INLINE void storeAs (Tag narrow, Vector values, float* target)
{
    hn::StoreU (hn::DemoteTo (narrow, values), narrow, target);
}

template <typename Tag, typename Vector>
HWY_INLINE void storeAs (Tag wide, Vector values, double* target)
{
    hn::StoreU (values, wide, target);
}

/** The phasors at the starts of a strip's tiles: real, then imaginary parts. */
template <typename Sample>
HWY_INLINE void findPhasors (const SoundingOscillation<Sample>& oscillation, int tile, Sample* phasors)
{
    const hn::CappedTag<double, synthesisStrip> wide;
    const hn::Rebind<Sample, decltype (wide)> narrow;
    const auto least = hn::Set (
        wide, static_cast<double> (std::numeric_limits<Sample>::min() / std::numeric_limits<Sample>::epsilon()));
    const auto anchorReal = hn::Set (wide, oscillation.anchorReal);
    const auto anchorImaginary = hn::Set (wide, oscillation.anchorImaginary);

    for (int t = 0; t < synthesisStrip; t += static_cast<int> (hn::MaxLanes (wide)))
    {
        const auto turnReal = hn::LoadU (wide, oscillation.turnReal + tile + t);
        const auto turnImaginary = hn::LoadU (wide, oscillation.turnImaginary + tile + t);
        const auto real = hn::NegMulAdd (anchorImaginary, turnImaginary, hn::Mul (anchorReal, turnReal));
        const auto imaginary = hn::MulAdd (anchorImaginary, turnReal, hn::Mul (anchorReal, turnImaginary));
        const auto audible = hn::Ge (hn::Max (hn::Abs (real), hn::Abs (imaginary)), least);
        storeAs (narrow, hn::IfThenElseZero (audible, real), phasors + t);
        storeAs (narrow, hn::IfThenElseZero (audible, imaginary), phasors + synthesisStrip + t);
    }
}

/** One oscillation in some tiles, whose table of 16 samples stays in registers. */
template <typename Sample>
HWY_INLINE void evaluateOne (const Sample* fine, const Sample* phasors, int tiles, Sample* values)
{
    constexpr int vectors = synthesisTile / lanes<Sample>;
    const hn::ScalableTag<Sample> tag;
    hn::VFromD<decltype (tag)> fineReal[vectors], fineImaginary[vectors];

#pragma GCC unroll 16
    for (int v = 0; v < vectors; ++v)
    {
        fineReal[v] = hn::Load (tag, fine + v * lanes<Sample>);
        fineImaginary[v] = hn::Load (tag, fine + synthesisTile + v * lanes<Sample>);
    }

#pragma GCC unroll 8
    for (int t = 0; t < tiles; ++t)
    {
        const auto real = hn::Set (tag, phasors[t]);
        const auto imaginary = hn::Set (tag, phasors[synthesisStrip + t]);

#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
            hn::Store (hn::NegMulAdd (imaginary, fineImaginary[v], hn::Mul (real, fineReal[v])), tag,
                       values + t * synthesisTile + v * lanes<Sample>);
    }
}

template <typename Sample>
void evaluate (SynthesisChunk<Sample>& chunk, int tile, int tiles)
{
    // In a loop of its own: what is stored here must have reached the cache before single numbers are read from it.
    for (int c = 0; c < chunk.count; ++c)
        findPhasors (chunk.sounding[c], tile, chunk.phasors + c * 2 * synthesisStrip);

    for (int c = 0; c < chunk.count; ++c)
    {
        const auto* fine = chunk.sounding[c].fine;
        const auto* phasors = chunk.phasors + c * 2 * synthesisStrip;
        auto* values = chunk.values + c * chunk.samples;

        if (tiles == synthesisStrip)
            evaluateOne (fine, phasors, synthesisStrip, values);
        else
            evaluateOne (fine, phasors, tiles, values);
    }
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
    constexpr int most =
        std::min (registerSums / ceramics, SynthesisChunk<Sample>::samples / lanes<Sample>) * lanes<Sample>;
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
