#pragma once

#include "PeerProblem.h"

namespace antinode::bench
{
/** Clp's dual simplex on the linear programme of the least peak, with all samples: minimise p, |samples| <= p limit.
   The last unknown of the result is p. */
PeerResult minimumPeakByClp (const PeerProblem&, double tolerance);
} // namespace antinode::bench
