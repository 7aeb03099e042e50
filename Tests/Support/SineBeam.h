#pragma once

#include <antinode_model/ModalModel.h>

namespace antinode::test
{
/** A pinned-pinned aluminium beam of 200 x 15 x 2 mm in closed form: sine shapes, f_k = k^2 f_1 with f_1 = 115.4 Hz,
   and ceramics that add neither mass nor stiffness, alpha_ki = kappa (phi_k' (right) - phi_k' (left)). Blevins 1979,
   table 8-1. */
ModalModel sineBeam (int modes, int ceramics, double qualityFactor = 60);
} // namespace antinode::test
