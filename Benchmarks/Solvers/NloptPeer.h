#pragma once

#include "PeerProblem.h"

namespace antinode::bench
{
/** NLopt's sequential quadratic programming (SLSQP), with all samples. */
PeerResult solveByNlopt (const PeerProblem&, double tolerance);
} // namespace antinode::bench
