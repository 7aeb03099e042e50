#pragma once

#include "AllocationProgress.h"
#include "LimitedAllocation.h"
#include "RowSystem.h"

#include <optional>

namespace antinode
{
/** Shares of the least objective within |Q x_i| <= ratio limits (i), by a dual active set: peaks at their limits are
   treated as equations, all wrong ones are exchanged at once. The ceramics meet in the rows alone, so the equations'
   matrix costs N_active^2 (N_d + N_r) / 2, and no matrix of all unknowns is made. Faster than the interior point where
   it ends, which it does not have to: then the limits may be out of reach.
    @param start  the shares of least objective without limits
    @return       shares within 1e-9 of the limits on all samples; nothing if more peaks are active than it is made for,
   or where the exchange leads nowhere [worker] Docs/Theory.md, section 4.3. */
std::optional<LimitedAllocation> activeSetShares (const WhitenedAllocation&, const RowSystem&, double ratio,
                                                  const Eigen::MatrixXd& start, const ShowAllocationProgress&);
} // namespace antinode
