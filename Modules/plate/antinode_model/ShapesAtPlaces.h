#pragma once

#include "ModalModel.h"

namespace antinode
{
/** The mode shapes at several places of the surface.
    @param places  x, y in m, one row per place
    @return        places x N_c, kg^-1/2, as shapesAt() gives each row
    @throws InputError  when a place lies outside the surface
    [worker] Docs/Theory.md, section 1.5. */
Eigen::MatrixXd shapesAtPlaces (const ModalModel&, const Eigen::MatrixX2d& places);
} // namespace antinode
