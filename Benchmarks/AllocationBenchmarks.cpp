#include "Focus/AllocationInstances.h"
#include "ReferenceLoop.h"

namespace antinode
{
namespace
{
// The sizes of the literature's and our own comparisons: ceramics, modes, samples, guards, rate.
const test::InstanceSize sizes[] = { { 2, 2, 500, 0, 96000, 0 },
                                     { 4, 6, 2000, 0, 96000, 0 },
                                     { 8, 15, 4800, 0, 192000, 0 },
                                     { 16, 40, 4800, 0, 192000, 0 } };

/** Arguments: size s1 to s4, slack in per cent of the least peak. */
void allocation (benchmark::State& state)
{
    const auto pattern = test::ModePattern::beam;
    auto problem = test::instance (pattern, test::RowKind::terminal, sizes[state.range (0) - 1], 1);
    const auto least = solveAllocation (problem, AllocationGoal::peak).certificate.leastPeakRatio;
    problem = test::withLimits (problem, 0.01 * static_cast<double> (state.range (1)), least);
    const bench::ReferenceRatio ratio (state);
    double gap = 0;

    for (auto run : state)
        gap = solveAllocation (problem, AllocationGoal::norm).certificate.gap;

    state.counters["gap"] = gap;
}
BENCHMARK (allocation)
    ->ArgsProduct ({ { 1, 2, 3, 4 }, { 130, 105 } })
    ->ArgNames ({ "s", "slack_percent" })
    ->Unit (benchmark::kMillisecond);

void leastPeak (benchmark::State& state)
{
    const auto problem =
        test::instance (test::ModePattern::beam, test::RowKind::terminal, sizes[state.range (0) - 1], 1);
    const bench::ReferenceRatio ratio (state);

    for (auto run : state)
        benchmark::DoNotOptimize (solveAllocation (problem, AllocationGoal::peak).certificate.leastPeakRatio);
}
BENCHMARK (leastPeak)->DenseRange (1, 4)->ArgName ("s")->Unit (benchmark::kMillisecond);
} // namespace
} // namespace antinode
