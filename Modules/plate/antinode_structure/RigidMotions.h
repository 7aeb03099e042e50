#pragma once

#include "ImmersedSpace.h"

namespace antinode
{
/** The rigid motions that nothing holds: unknowns x 0 to 3, orthonormal in M.
    @param mass  M of the space
    [worker] Docs/Theory.md, section 1.13. */
Eigen::MatrixXd freeMotions (const BendingProblem&, const ImmersedSpace&, const BlockBandedMatrix& mass);
} // namespace antinode
