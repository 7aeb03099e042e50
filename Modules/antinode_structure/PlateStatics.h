#pragma once

#include "PlateSolution.h"

namespace antinode
{
/** The static deflection of a plate under one volt on each ceramic: all modes at once, without rigid motions.
    @return  N_p x N_b, m/V, on the points of the grid
    [worker] Docs/Theory.md, section 1.8. */
Eigen::MatrixXd staticShapes (const PlateDescription&, const PlateSolution&, const PlateGrid&);

/** The contribution of the modes beyond those of a model to its response well below their frequencies: its static shapes without
    the part that its own modes represent, phi_k alpha_ki / omega_k^2. The modal sum converges slowly where the surface lies on the
    ceramic itself; with this it is right.
    @param model  of the same plate, with a grid
    @return       N_p x N_b, m/V
    [worker] Docs/Theory.md, section 1.8. */
Eigen::MatrixXd staticResidual (const PlateDescription&, const PlateSolution&, const ModalModel& model);
} // namespace antinode
