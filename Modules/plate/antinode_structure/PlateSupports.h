#pragma once

#include "ImmersedSpace.h"

namespace antinode
{
/** Adds what holds the edges of a plate: springs, and by Nitsche's method the conditions of simply supported and
   clamped edges. The matrix may become indefinite: functions that have hardly any part on the plate get eigenvalues far
   below all others. [worker] Docs/Theory.md, section 1.13; Nitsche, Abh. Math. Sem. Univ. Hamburg 36 (1971) 9-15. */
void addEdgeTerms (BlockBandedMatrix& stiffness, const BendingProblem&, const ImmersedSpace&);

/** How much rigid motions are held, in units of the plate's own stiffness: with r = (1, x, y) about the middle of the
   plate and in units of its size, about the integral of r r' over what holds it, each by its stiffness. 3 x 3,
   semidefinite; what it maps to zero moves freely. [any] */
Eigen::Matrix3d rigidSupport (const BendingProblem&);

/** The rigid motions that nothing holds: unknowns x 0 to 3, orthonormal in M.
    @param mass  M of the space
    [worker] Docs/Theory.md, section 1.13. */
Eigen::MatrixXd freeMotions (const BendingProblem&, const ImmersedSpace&, const BlockBandedMatrix& mass);
} // namespace antinode
