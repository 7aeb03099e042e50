#pragma once

#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>

#include <string>
#include <vector>

namespace antinode
{
/** The modal velocities of a field: by mass weights (24) where the shapes cover the whole body, else by weighted least
   squares over all modes.
    @param field  N_p values, m/s
    [worker] Docs/Theory.md, section 2.2; paper (24). */
ProjectedTarget projectField (const ModalModel&, const Eigen::VectorXd& field);

/** The controlled modes and the part of the target that they represent. */
struct ModeSelection
{
    std::vector<int> modes;    ///< Ascending indices.
    Eigen::VectorXd wanted;    ///< Their modal velocities, m/s kg^1/2.
    Eigen::VectorXd truncated; ///< N_p: the field that they represent, m/s.
    double captured = 0;       ///< sqrt (S/K), 0 to 1.
};

/** What the modes capture together where a focus does not choose them: sqrt (S/K). [any] */
constexpr double defaultCapture()
{
    return 0.99;
}

/** Chooses the modes to control. Motions as a rigid body, and modes that no ceramic excites
    (participation below 1e-9 of the largest), are left out.
    @throws InputError  when no mode is left, more are requested than exist, or the requested captured fraction cannot
   be reached [worker] Docs/Theory.md, section 2.3. */
ModeSelection selectModes (const ModalModel&, const ProjectedTarget&, const ModeChoice&);

/** The part of a target that given modes represent: the last step of selectModes, for modes chosen by other means.
    [worker] */
ModeSelection restrictToModes (const ModalModel&, const ProjectedTarget&, std::vector<int> modes);

/** Where the part of a wanted field goes that the controlled modes do not represent: fractions of its energy measure K.
    Docs/Theory.md, section 2.3. */
struct CaptureLosses
{
    double uncontrolled = 0; ///< Modes that ceramics move, but that are not controlled.
    double blind = 0;        ///< Modes that no ceramic moves.
    double beyond = 0;       ///< Waves shorter than all modes of the model, and edges that cannot move.
};

/** [worker] */
CaptureLosses captureLosses (const ModalModel&, const FocusDesign&, const FocusMoment&);

/** The largest of these losses as a sentence, with the key to change: "The 6 controlled of 34 modes represent ...".
    [worker] */
std::string lossInWords (const ModalModel&, const FocusDesign&, const FocusMoment&);

/** What the transients add to that as a sentence, with the key to change: modes that are not controlled and still move,
   or controlled modes that miss their velocities.
    @param modalVelocities  N_m, at the moment, m/s kg^1/2
    @param error            the field error against the truncated field
    [any] */
std::string transientInWords (const FocusDesign&, const FocusMoment&, const Eigen::VectorXd& modalVelocities,
                              double error);
} // namespace antinode
