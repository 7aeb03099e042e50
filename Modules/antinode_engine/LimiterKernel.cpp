#include "LimiterKernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antinode_engine/LimiterKernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

template <typename Sample>
constexpr int lanes = static_cast<int> (hn::MaxLanes (hn::ScalableTag<Sample>()));

template <typename Sample>
int finiteSamples (const Sample* samples, int count)
{
    const hn::ScalableTag<Sample> tag;
    const auto largest = hn::Set (tag, std::numeric_limits<Sample>::max());
    int n = 0;

    // Written so that a comparison with NaN ends the loop.
    while (n + lanes<Sample> <= count && hn::AllTrue (tag, hn::Le (hn::Abs (hn::LoadU (tag, samples + n)), largest)))
        n += lanes<Sample>;

    while (n < count && std::isfinite (samples[n]))
        ++n;

    return n;
}

template <typename Sample>
std::int64_t clamp (Sample* samples, int count, Sample limit)
{
    const hn::ScalableTag<Sample> tag;
    const auto high = hn::Set (tag, limit), low = hn::Set (tag, -limit);
    std::int64_t beyond = 0;
    int n = 0;

    for (; n + lanes<Sample> <= count; n += lanes<Sample>)
    {
        const auto sample = hn::LoadU (tag, samples + n);
        beyond += static_cast<std::int64_t> (hn::CountTrue (tag, hn::Gt (hn::Abs (sample), high)));
        hn::StoreU (hn::Min (hn::Max (sample, low), high), tag, samples + n);
    }

    for (; n < count; ++n)
    {
        beyond += std::abs (samples[n]) > limit;
        samples[n] = std::min (std::max (samples[n], -limit), limit);
    }

    return beyond;
}

template <typename Sample>
void multiply (Sample* samples, const Sample* gains, int count)
{
    const hn::ScalableTag<Sample> tag;
    int n = 0;

    for (; n + lanes<Sample> <= count; n += lanes<Sample>)
        hn::StoreU (hn::Mul (hn::LoadU (tag, samples + n), hn::LoadU (tag, gains + n)), tag, samples + n);

    for (; n < count; ++n)
        samples[n] *= gains[n];
}
} // namespace

LimiterKernel<double> doubleLimiterKernel()
{
    return { &finiteSamples<double>, &clamp<double>, &multiply<double> };
}

LimiterKernel<float> floatLimiterKernel()
{
    return { &finiteSamples<float>, &clamp<float>, &multiply<float> };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (doubleLimiterKernel);
HWY_EXPORT (floatLimiterKernel);
} // namespace

template <>
LimiterKernel<double> limiterKernel<double>()
{
    return HWY_DYNAMIC_DISPATCH (doubleLimiterKernel)();
}

template <>
LimiterKernel<float> limiterKernel<float>()
{
    return HWY_DYNAMIC_DISPATCH (floatLimiterKernel)();
}
} // namespace antinode
#endif
