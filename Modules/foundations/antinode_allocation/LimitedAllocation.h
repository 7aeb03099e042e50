#pragma once

#include "Allocation.h"
#include "WhitenedAllocation.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** A value that the objective of no X goes below which meets the hard rows and keeps |Q x_i| <= ratio limits (i) on all
   samples. Weak duality, so it holds for any multipliers at all; those of the rows are chosen here as the best for
   those of the samples.
    @param sampleMultipliers  z, N_s x N_b: upper less lower
    [worker] Docs/Theory.md, section 4. */
double leastNormBound (const WhitenedAllocation&, const RowSystem&, const Eigen::MatrixXd& sampleMultipliers,
                       double ratio);

/** A value that max |Q x_i| / limits (i) of no X goes below which meets the hard rows. Weak duality, for any
   multipliers: those of the samples are first repaired so that they balance the rows.
    @param rowMultipliers     y, N_r: hard rows only, the problem must have no guards
    @param sampleMultipliers  z, N_s x N_b
    [worker] Docs/Theory.md, section 4. */
double minimumPeakBound (const WhitenedAllocation&, const Eigen::VectorXd& rowMultipliers,
                         Eigen::MatrixXd sampleMultipliers);

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

/** Local maxima of |voltage| above a threshold each, one list of samples per ceramic: between two zeros only they can
   break a limit.
    @param voltages    N_s x N_b
    @param thresholds  N_b
    [worker] */
std::vector<std::vector<Eigen::Index>> localPeaks (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& thresholds);
} // namespace antinode
