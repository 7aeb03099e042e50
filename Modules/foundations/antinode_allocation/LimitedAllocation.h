#pragma once

#include "AllocationProgress.h"
#include "RowSystem.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The amount of work. */
struct AllocationEffort
{
    int iterations = 0, rounds = 0;
};

/** Shares with their value and its certified lower bound. */
struct LimitedAllocation
{
    Eigen::MatrixXd shares; ///< N_d x N_b, hard rows met to rounding.
    double value = 0;       ///< Peak ratio on all samples, or objective.
    double bound = 0;       ///< Certified lower bound of the value.
    AllocationEffort effort;

    /** (value - bound) / value. [any] */
    double gap() const;

    /** Takes over the better shares and bound. [any] */
    void improve (const Eigen::MatrixXd& newShares, double newValue, double newBound);
};

/** Shares whose largest |voltage| / limit is the least that these drives allow, to 5e-7, for a problem without guards.
    @param easyRatio  once a ratio below this is reached the search ends early
    [worker] Docs/Theory.md, section 4. */
LimitedAllocation minimumPeakShares (const WhitenedAllocation&, const RowSystem&, double easyRatio,
                                     const ShowAllocationProgress&);

/** Shares of the least objective within |Q x_i| <= ratio limits (i), which they keep exactly on all samples.
    @param inside  shares that meet the hard rows and stay below those limits
    [worker] Docs/Theory.md, section 4. */
LimitedAllocation leastNormShares (const WhitenedAllocation&, const RowSystem&, double ratio,
                                   const Eigen::MatrixXd& inside, const ShowAllocationProgress&);
} // namespace antinode
