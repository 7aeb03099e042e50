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
} // namespace antinode
