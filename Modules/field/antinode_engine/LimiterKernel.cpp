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

constexpr hn::ScalableTag<double> tag;
constexpr int lanes = static_cast<int> (hn::MaxLanes (tag));

int finiteSamples (const double* samples, int count)
{
    const auto largest = hn::Set (tag, std::numeric_limits<double>::max());
    int n = 0;

    // Written so that a comparison with NaN ends the loop.
    while (n + lanes <= count && hn::AllTrue (tag, hn::Le (hn::Abs (hn::LoadU (tag, samples + n)), largest)))
        n += lanes;

    while (n < count && std::isfinite (samples[n]))
        ++n;

    return n;
}

std::int64_t clamp (double* samples, int count, double limit)
{
    const auto high = hn::Set (tag, limit), low = hn::Set (tag, -limit);
    std::int64_t beyond = 0;
    int n = 0;

    for (; n + lanes <= count; n += lanes)
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
} // namespace

LimiterKernel limiterKernelOfTarget()
{
    return { &finiteSamples, &clamp };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (limiterKernelOfTarget);
} // namespace

LimiterKernel limiterKernel()
{
    return HWY_DYNAMIC_DISPATCH (limiterKernelOfTarget)();
}
} // namespace antinode
#endif
