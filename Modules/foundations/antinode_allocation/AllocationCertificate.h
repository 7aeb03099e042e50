#pragma once

#include "RowSystem.h"

#include <Eigen/Core>

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
} // namespace antinode
