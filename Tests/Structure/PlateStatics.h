#pragma once

#include <antinode_structure/PlateSolution.h>

namespace antinode
{
/** What modal sums are checked against: the static deflection of a plate under one volt on each ceramic: all modes at
    once, without rigid motions.
    @return  N_p x N_b, m/V, on the points of the grid
    [worker] Docs/Theory.md, section 1.8. */
Eigen::MatrixXd staticShapes (const PlateDescription&, const PlateSolution&, const PlateGrid&);
} // namespace antinode
