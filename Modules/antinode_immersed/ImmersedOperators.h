#pragma once

#include "ImmersedSpace.h"

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

/** Adds factor left' right to a symmetric matrix, for functions of these numbers; the sum over all calls is symmetric.
    [worker] */
void addToMatrix (BlockBandedMatrix&, const std::vector<Eigen::Index>& numbers, const Eigen::MatrixXd& local);
} // namespace antinode
