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

template <typename Sample>
void addVector (const float* from, Sample amplitude, Sample* to)
{
    const hn::ScalableTag<Sample> tag;
    const auto gain = hn::Set (tag, amplitude);

    if constexpr (std::is_same_v<Sample, float>)
        hn::StoreU (hn::MulAdd (gain, hn::LoadU (tag, from), hn::LoadU (tag, to)), tag, to);
    else
    {
        const hn::Rebind<float, hn::ScalableTag<Sample>> half;
        hn::StoreU (hn::MulAdd (gain, hn::PromoteTo (tag, hn::LoadU (half, from)), hn::LoadU (tag, to)), tag, to);
    }
}

/** What is left over goes through a whole vector too: a sum that is rounded once and one that is rounded twice differ.
 */
template <typename Sample>
void addScaled (const float* from, Sample amplitude, Sample* to, int count)
{
    int n = 0;

    for (; n + sampleLanes<Sample> <= count; n += sampleLanes<Sample>)
        addVector (from + n, amplitude, to + n);

    if (n == count)
        return;

    float last[sampleLanes<Sample>] {};
    Sample sums[sampleLanes<Sample>] {};
    std::copy (from + n, from + count, last);
    std::copy (to + n, to + count, sums);
    addVector (last, amplitude, sums);
    std::copy_n (sums, count - n, to + n);
}
} // namespace

SampleKernel<double> doubleSampleKernel()
{
    return { &addScaled<double> };
}

SampleKernel<float> floatSampleKernel()
{
    return { &addScaled<float> };
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
