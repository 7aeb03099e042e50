#pragma once

#include "PeerProblem.h"

namespace antinode::bench
{
/** Ipopt (Debian's, with MUMPS) on the quadratic programme with all samples, told that it is one: constant Jacobian and
   Hessian, Mehrotra's steps. */
PeerResult solveByIpopt (const PeerProblem&, double tolerance);
} // namespace antinode::bench
