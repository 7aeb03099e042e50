#include "ReferenceLoop.h"

#include <algorithm>
#include <chrono>

namespace antinode::bench
{
namespace
{
std::int64_t nanosecondsNow()
{
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds (1);
}

double oneRun()
{
    const auto begin = nanosecondsNow();
    double value = 1;
    benchmark::DoNotOptimize (value);

    for (int i = 0; i < 1000000; ++i)
        value = value * 0.999999 + 1e-6;

    benchmark::DoNotOptimize (value);
    benchmark::ClobberMemory();
    return 1e-9 * static_cast<double> (nanosecondsNow() - begin);
}
} // namespace

double referenceSeconds()
{
    auto minimum = oneRun();

    for (int i = 0; i < 4; ++i)
        minimum = std::min (minimum, oneRun());

    return minimum;
}

ReferenceRatio::ReferenceRatio (benchmark::State& stateToUse)
    : state (stateToUse), reference (referenceSeconds()), begin (nanosecondsNow())
{
}

ReferenceRatio::~ReferenceRatio()
{
    const auto seconds = 1e-9 * static_cast<double> (nanosecondsNow() - begin);
    state.counters["references"] = seconds / static_cast<double> (state.iterations()) / reference;
}
} // namespace antinode::bench
