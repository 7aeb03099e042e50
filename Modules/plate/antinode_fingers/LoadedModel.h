#pragma once

#include "Finger.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** The mode shapes under a finger, averaged over the part of its contact that lies on the surface: even pressure.
    @return  N_c, kg^-1/2
    @throws InputError  when its middle lies outside the surface
    [worker] Docs/Theory.md, section 1.12. */
Eigen::RowVectorXd contactShapes (const ModalModel&, const Finger&);

/** A surface with fingers on it, as its own exact modes: complex ones, since fingers damp where they are. It takes the
    modes of the model, of a free one with its motion as a rigid body, and answers every voltage as these modes with the
   fingers' masses, dampers and springs in M, C and K do. A motion that a finger damps so strongly that it does not
   oscillate is two modes with damping ratios just below 1. Without fingers the model itself.
    @param model  with real modes
    @throws InputError  when the modes are complex, the size of shapes is not known, or fingers are not usable
    [worker] Docs/Theory.md, section 1.12. */
ModalModel loadedModel (const ModalModel& model, const std::vector<Finger>& fingers);
} // namespace antinode
