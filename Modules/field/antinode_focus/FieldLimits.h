#pragma once

#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
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
