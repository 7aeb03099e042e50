#pragma once

#include "PeerProblem.h"

namespace antinode::bench
{
/** ALGLIB's interior point method for dense quadratic programmes (DENSE-IPM), with all samples. */
PeerResult solveByAlglib (const PeerProblem&, double tolerance);
} // namespace antinode::bench
