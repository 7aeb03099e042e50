#include "SampleKernel.h"

#include <algorithm>
#include <type_traits>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/SampleKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

template <typename Sample>
constexpr int sampleLanes = static_cast<int> (hn::MaxLanes (hn::ScalableTag<Sample>()));

/** So many samples in the precision of the sums. */
template <typename Sample>
auto loadSamples (const float* from)
{
    const hn::ScalableTag<Sample> tag;

    if constexpr (std::is_same_v<Sample, float>)
        return hn::LoadU (tag, from);
    else
        return hn::PromoteTo (tag, hn::LoadU (hn::Rebind<float, hn::ScalableTag<Sample>>(), from));
}

template <typename Sample>
void addVector (const float* from, const Sample* gains, Sample amplitude, Sample* to)
{
    const hn::ScalableTag<Sample> tag;
    auto gain = hn::Set (tag, amplitude);

    if (gains != nullptr)
        gain = hn::Mul (gain, hn::LoadU (tag, gains));

    hn::StoreU (hn::MulAdd (gain, loadSamples<Sample> (from), hn::LoadU (tag, to)), tag, to);
}

/** What is left over goes through a whole vector too: a sum that is rounded once and one that is rounded twice differ.
    @param gains  none: all 1 */
template <typename Sample>
HWY_INLINE void addSamples (const float* from, const Sample* gains, Sample amplitude, Sample* to, int count)
{
    const auto isFaded = gains != nullptr;
    int n = 0;

    for (; n + sampleLanes<Sample> <= count; n += sampleLanes<Sample>)
        addVector (from + n, isFaded ? gains + n : nullptr, amplitude, to + n);

    if (n == count)
        return;

    float last[sampleLanes<Sample>] {};
    Sample lastGains[sampleLanes<Sample>] {}, sums[sampleLanes<Sample>] {};
    std::copy (from + n, from + count, last);
    std::copy (to + n, to + count, sums);

    if (isFaded)
        std::copy (gains + n, gains + count, lastGains);

    addVector (last, isFaded ? lastGains : nullptr, amplitude, sums);
    std::copy_n (sums, count - n, to + n);
}

template <typename Sample>
void addScaled (const float* from, Sample amplitude, Sample* to, int count)
{
    addSamples<Sample> (from, nullptr, amplitude, to, count);
}

template <typename Sample>
void addFaded (const float* from, const Sample* gains, Sample amplitude, Sample* to, int count)
{
    addSamples<Sample> (from, gains, amplitude, to, count);
}
} // namespace

SampleKernel<double> doubleSampleKernel()
{
    return { &addScaled<double>, &addFaded<double> };
}

SampleKernel<float> floatSampleKernel()
{
    return { &addScaled<float>, &addFaded<float> };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (doubleSampleKernel);
HWY_EXPORT (floatSampleKernel);
} // namespace

template <>
SampleKernel<double> sampleKernel<double>()
{
    return HWY_DYNAMIC_DISPATCH (doubleSampleKernel)();
}

template <>
SampleKernel<float> sampleKernel<float>()
{
    return HWY_DYNAMIC_DISPATCH (floatSampleKernel)();
}
} // namespace antinode
#endif
