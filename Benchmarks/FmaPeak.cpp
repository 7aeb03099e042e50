#include "FmaPeak.h"

// Highway includes this file once a target, each time with another HWY_NAMESPACE.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FmaPeak.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace antinode::bench::HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

constexpr int chains = 12, loops = 20000; // more chains than latency times units, fewer than registers
} // namespace

double runChains()
{
    const hn::ScalableTag<double> tag;
    const auto factor = hn::Set (tag, 0.999), term = hn::Set (tag, 1e-3);
    hn::VFromD<decltype (tag)> values[chains];

#pragma GCC unroll 12
    for (int i = 0; i < chains; ++i)
        values[i] = hn::Set (tag, i);

    for (int loop = 0; loop < loops; ++loop)
#pragma GCC unroll 12
        for (int i = 0; i < chains; ++i)
            values[i] = hn::MulAdd (values[i], factor, term);

#pragma GCC unroll 12
    for (int i = 1; i < chains; ++i)
        values[0] = hn::Add (values[0], values[i]);

    return hn::GetLane (values[0]) + chains * loops; // the loop cannot be left out
}

int lanesOfVector()
{
    return static_cast<int> (hn::MaxLanes (hn::ScalableTag<double>()));
}
} // namespace antinode::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace antinode::bench
{
namespace
{
HWY_EXPORT (runChains);
HWY_EXPORT (lanesOfVector);
} // namespace

double fmaVectorsPerSecond()
{
    const auto seconds = measureSeconds ([] { benchmark::DoNotOptimize (HWY_DYNAMIC_DISPATCH (runChains)()); }, 1);
    return 12.0 * 20000 / seconds;
}

int fmaLanes()
{
    return HWY_DYNAMIC_DISPATCH (lanesOfVector)();
}
} // namespace antinode::bench
#endif
