#include "OwnTable.h"

#include "Allocation/AllocationInstances.h"
#include "ReferenceLoop.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace antinode::bench
{
namespace
{
/** An answer with the least processor time of as many runs as are cheap. */
struct Timed
{
    Allocation allocation;
    double seconds = 1e9;
};

Timed timed (const AllocationProblem& problem, AllocationGoal goal)
{
    constexpr auto maximumRuns = 5;
    constexpr auto enough = 2.0; // s in all
    Timed result;
    double sum = 0;

    for (int n = 0; n < maximumRuns && sum < enough; ++n)
    {
        const auto begin = std::clock();
        result.allocation = solveAllocation (problem, goal);
        const auto seconds = static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
        result.seconds = std::min (result.seconds, seconds);
        sum += seconds;
    }

    return result;
}

void print (int size, test::ModePattern pattern, test::RowKind kind, const char* goal, const Timed& timed)
{
    const auto& certificate = timed.allocation.certificate;
    std::printf ("| s%d | %s | %s | %s | %.3g | %.3g | %d, %d | %.1e | %.1e |\n", size,
                 pattern == test::ModePattern::beam ? "beam" : "plate",
                 kind == test::RowKind::identity ? "(29)" : "exact", goal, 1000 * timed.seconds,
                 timed.seconds / referenceSeconds(), certificate.rounds, certificate.iterations, certificate.gap,
                 certificate.status == AllocationStatus::optimal ? certificate.peakRatio - 1 : 0);
    std::fflush (stdout);
}

void printKind (int size, test::ModePattern pattern, test::RowKind kind)
{
    const auto problem = test::instance (pattern, kind, test::standardSizes[size - 1], 1);
    auto peak = timed (problem, AllocationGoal::peak);
    const auto minimum = peak.allocation.certificate.minimumPeakRatio;
    peak.allocation.certificate.peakRatio = 1; // Nothing is limited.
    print (size, pattern, kind, "least peak", peak);

    for (const auto& [slack, name] : { std::pair (1.3, "1.3"), std::pair (1.05, "1.05"), std::pair (0.8, "0.8") })
        print (size, pattern, kind, name, timed (test::withLimits (problem, slack, minimum), AllocationGoal::norm));
}
} // namespace

void printOwnTable (int largestSize)
{
    std::puts ("| size | modes | rows | goal or limit over least peak | ms | reference loops | rounds, steps | gap | "
               "beyond limit |");
    std::puts ("|---|---|---|---|---|---|---|---|---|");

    for (int size = 1; size <= largestSize; ++size)
        for (const auto pattern : { test::ModePattern::beam, test::ModePattern::plate })
            for (const auto kind : { test::RowKind::identity, test::RowKind::terminal })
                printKind (size, pattern, kind);
}
} // namespace antinode::bench
