#pragma once

#include "ModalModel.h"

namespace antinode
{
/** A device that nothing holds, or only softly, with its motions as a rigid body as first modes where its own modes
   lack them: no ceramic drives them, but who touches the surface pushes the whole of it. A drawing says whether it is
   free; of a measured device so does an outline without held edges. Other devices, and complex modes, are left as they
   are. [worker] Docs/Theory.md, section 1.12. */
ModalModel withRigidMotion (ModalModel);

/** How many of the first modes are motions as a rigid body on a suspension, 0 to 3. Their shapes are planes to .5 % of
    their energy; a clamped beam's first shape is to 1 %. 0 for models of fewer than 12 points. [any] */
int suspensionModes (const ModalModel&);

/** The part of a field's energy that is motion as a rigid body of a free or softly held device, kg m^2/s^2: no ceramic
    reaches it. 0 for complex modes, and where shapes cover a part of the body only.
    @param field            N_p, m/s
    @param modalVelocities  what modes have of it, at most N_m, m/s kg^1/2
    [any] Docs/Theory.md, section 2.3. */
double rigidEnergy (const ModalModel&, const Eigen::VectorXd& field, const Eigen::VectorXd& modalVelocities);
} // namespace antinode
