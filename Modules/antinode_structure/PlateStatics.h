#pragma once

#include "PlateSolution.h"

namespace antinode
{
/** How a plate bends under one volt on each ceramic that stays on: all modes at once, rigid motions left out.
    @return  N_p x N_b, m/V, on the points of the grid
    [worker] Docs/Theory.md, section 1.8. */
Eigen::MatrixXd staticShapes (const PlateDescription&, const PlateSolution&, const PlateGrid&);

/** What the modes beyond those of a model add to its response well below their frequencies: its static shapes without
    the part that its own modes carry, phi_k alpha_ki / omega_k^2. The modal sum converges slowly where the surface lies on the
    ceramic itself; with this it is right.
    @param model  of the same plate, with a grid
    @return       N_p x N_b, m/V
    [worker] Docs/Theory.md, section 1.8. */
Eigen::MatrixXd staticResidual (const PlateDescription&, const PlateSolution&, const ModalModel& model);
} // namespace antinode
