#pragma once

#include "IdentifiedModes.h"

namespace antinode
{
/** Gives shapes and participations their sizes, and shapes the sign that makes their largest value positive; products
   stay.

    A driving point comes first, then known masses, then the convention. Deviations and complex shapes go along.
    @param masses  N_p: kg, or empty
    [worker] Docs/Theory.md, section 8.6. */
void scaleShapes (IdentifiedModes&, const Eigen::VectorXd& masses);

/** Shapes made orthogonal one after the other by Gram and Schmidt, as the paper did, each as long as before;
   participation as velocities follow: v = Phi q = Q R q. Of a structure that is mapped in part this spoils shapes:
   their cross-talk is physics.
    @param masses  N_p: kg, or empty for equal ones; points without data do not count
    [worker] Docs/Theory.md, section 8.6; paper, section 5. */
void orthogonalise (IdentifiedModes&, const Eigen::VectorXd& masses);
} // namespace antinode
