#pragma once

#include "ImmersedSpace.h"

#include <antinode_numerics/BlockBandedMatrix.h>

namespace antinode
{
/** Stiffness and mass of a plate on an immersed space, and the loads of its patches. */
struct ImmersedOperators
{
    BlockBandedMatrix stiffness, mass;
    Eigen::MatrixXd loads; ///< unknowns x patches: integral moment . (w,11 w,22 2 w,12) over each.
};

/** [worker] Docs/Theory.md, section 1.13. */
ImmersedOperators immersedOperators (const BendingProblem&, const ImmersedSpace&);

/** L D L' of stiffness - shift mass. [worker] */
BlockBandedFactor factorShifted (const ImmersedOperators&, double shift);

/** Adds a symmetric matrix for functions of these numbers, of which the lower triangle is read. [worker] */
void addToMatrix (BlockBandedMatrix&, const std::vector<Eigen::Index>& numbers,
                  const Eigen::Ref<const Eigen::MatrixXd>& local);
} // namespace antinode
