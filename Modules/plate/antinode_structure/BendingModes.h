#pragma once

#include "ImmersedSpace.h"
#include "Resolution.h"

namespace antinode
{
/** The lowest modes of a plate. */
struct BendingModes
{
    ImmersedSpace space;
    Eigen::VectorXd eigenvalues;   ///< omega^2 of the flexible modes, ascending.
    Eigen::MatrixXd coefficients;  ///< unknowns x modes, mass-normalised.
    Eigen::MatrixXd participation; ///< modes x patches: integral moment . (w,11 w,22 2 w,12).
    int rigidBodyModes = 0;        ///< Motions that nothing holds, left out: 0 to 3.
};

/** The flexible modes of a plate, none missing and none false: rigid motions are known exactly, and the number of the
   others is proven by inertia.
    @param count  how many
    @throws InputError  where it cannot be solved, saying why
    [worker] Docs/Theory.md, section 1.13. */
BendingModes bendingModes (const BendingProblem&, int count, const ImmersedResolution&);
} // namespace antinode
