#include "SampleKernel.h"

#include <algorithm>

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

constexpr hn::ScalableTag<double> tag;
constexpr hn::Rebind<float, decltype (tag)> floats;
constexpr int lanes = static_cast<int> (hn::MaxLanes (tag));

void addVector (const float* from, const double* gains, double amplitude, double* to)
{
    auto gain = hn::Set (tag, amplitude);

    if (gains != nullptr)
        gain = hn::Mul (gain, hn::LoadU (tag, gains));

    const auto samples = hn::PromoteTo (tag, hn::LoadU (floats, from));
    hn::StoreU (hn::MulAdd (gain, samples, hn::LoadU (tag, to)), tag, to);
}

/** What is left over goes through a whole vector too: a sum that is rounded once and one that is rounded twice differ.
    @param gains  none: all 1 */
HWY_INLINE void addSamples (const float* from, const double* gains, double amplitude, double* to, int count)
{
    const auto isFaded = gains != nullptr;
    int n = 0;

    for (; n + lanes <= count; n += lanes)
        addVector (from + n, isFaded ? gains + n : nullptr, amplitude, to + n);

    if (n == count)
        return;

    float last[lanes] {};
    double lastGains[lanes] {}, sums[lanes] {};
    std::copy (from + n, from + count, last);
    std::copy (to + n, to + count, sums);

    if (isFaded)
        std::copy (gains + n, gains + count, lastGains);

    addVector (last, isFaded ? lastGains : nullptr, amplitude, sums);
    std::copy_n (sums, count - n, to + n);
}

void addScaled (const float* from, double amplitude, double* to, int count)
{
    addSamples (from, nullptr, amplitude, to, count);
}
} // namespace

SampleKernel sampleKernelOfTarget()
{
    return { &addScaled, &addSamples };
}
} // namespace antinode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode
{
namespace
{
HWY_EXPORT (sampleKernelOfTarget);
} // namespace

SampleKernel sampleKernel()
{
    return HWY_DYNAMIC_DISPATCH (sampleKernelOfTarget)();
}
} // namespace antinode
#endif
