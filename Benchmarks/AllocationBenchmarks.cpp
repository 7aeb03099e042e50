#include "Allocation/AllocationInstances.h"
#include "ReferenceLoop.h"

namespace antinode
{
namespace
{
AllocationProblem instance (const benchmark::State& state)
{
    return test::instance (state.range (1) == 0 ? test::ModePattern::beam : test::ModePattern::plate,
                           state.range (2) == 0 ? test::RowKind::identity : test::RowKind::terminal,
                           test::standardSizes[state.range (0) - 1], 1);
}

/** Arguments: size s1 to s6, beam or plate, the paper's rows or exact ones, slack in per cent of the least peak. */
void allocation (benchmark::State& state)
{
    auto problem = instance (state);
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    problem = test::withLimits (problem, 0.01 * static_cast<double> (state.range (3)), minimum);
    const bench::ReferenceRatio ratio (state);
    double gap = 0;

    for (auto run : state)
        gap = solveAllocation (problem, AllocationGoal::norm).certificate.gap;

    state.counters["gap"] = gap;
}
BENCHMARK (allocation)
    ->ArgsProduct ({ { 1, 2, 3, 4, 5 }, { 0, 1 }, { 0, 1 }, { 130, 105, 80 } })
    ->ArgsProduct ({ { 6 }, { 1 }, { 1 }, { 130, 105 } })
    ->ArgNames ({ "s", "plate", "exact", "slack_percent" })
    ->Unit (benchmark::kMillisecond);

void minimumPeak (benchmark::State& state)
{
    const auto problem = instance (state);
    const bench::ReferenceRatio ratio (state);

    for (auto run : state)
        benchmark::DoNotOptimize (solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio);
}
BENCHMARK (minimumPeak)
    ->ArgsProduct ({ { 1, 2, 3, 4, 5, 6 }, { 1 }, { 1 } })
    ->ArgNames ({ "s", "plate", "exact" })
    ->Unit (benchmark::kMillisecond);
} // namespace
} // namespace antinode
