#pragma once

#include <functional>
#include <stdexcept>

namespace antinode
{
/** The stage of the solver. */
enum class AllocationStage
{
    activeSet, ///< The least norm by the voltages' peaks.
    leastPeak, ///< The least peak by interior points.
    leastNorm  ///< The least norm by interior points.
};

/** The progress of a solver. */
struct AllocationProgress
{
    AllocationStage stage = AllocationStage::activeSet;
    int steps = 0;  ///< Of this stage, rounds of the active set or steps of the interior point.
    double gap = 1; ///< Certified so far, relative; 1 where nothing is yet.
};

/** Called before every step, on the thread that solves. Returns whether to go on. */
using AllocationWatch = std::function<bool (const AllocationProgress&)>;

/** Thrown after a watch has cancelled: no error, but no result. */
class AllocationCancelled : public std::runtime_error
{
public:
    AllocationCancelled() : std::runtime_error ("the allocation was cancelled") {}
};

/** Tells the watch, where there is one. @throws AllocationCancelled  when it says no [worker] */
inline void report (const AllocationWatch& watch, const AllocationProgress& progress)
{
    if (watch && ! watch (progress))
        throw AllocationCancelled();
}
} // namespace antinode
