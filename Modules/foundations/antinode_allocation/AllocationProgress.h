#pragma once

#include <antinode_base/Watch.h>

#include <functional>

namespace antinode
{
/** The stage of the solver. */
enum class AllocationStage
{
    activeSet,   ///< The least norm by the voltages' peaks.
    minimumPeak, ///< The least peak by interior points.
    leastNorm    ///< The least norm by interior points.
};

/** The progress of a solver. */
struct AllocationProgress
{
    AllocationStage stage = AllocationStage::activeSet;
    int steps = 0;  ///< Of this stage, rounds of the active set or steps of the interior point.
    double gap = 1; ///< Certified so far, relative; 1 where nothing is yet.
};

/** Called before every step, on the thread that solves. */
using ShowAllocationProgress = std::function<void (const AllocationProgress&)>;

/** Shows the progress, where it is to be shown, and looks at the watch. @throws Cancelled  as checkWatch() [worker] */
inline void report (const ShowAllocationProgress& show, const AllocationProgress& progress)
{
    if (show)
        show (progress);

    checkWatch();
}
} // namespace antinode
