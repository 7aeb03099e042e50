#pragma once

#include "Identification.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** A known device after a drift, and what has changed. N_m modes, N_b ceramics. */
struct RetunedModel
{
    ModalModel model;                 ///< Frequencies, dampings and participation updated; shapes as they were.
    std::vector<bool> found;          ///< N_m: whether the mode was seen; others moved with their neighbours.
    Eigen::VectorXd frequencyChanges; ///< N_m: relative.
    Eigen::VectorXd dampingChanges;   ///< N_m: relative.
    Eigen::VectorXd
        participationScales;        ///< N_b: by which each ceramic's participation was multiplied; 1 where not seen.
    double delay = 0;               ///< s
    double reconstructionError = 0; ///< dB, of the few responses.
};

/** Updates frequencies, damping and participation of a known device from the responses of a few points.
    @param model      as it was known; its ceramics are the references, in their order
    @param responses  at points on the model's surface, driven by voltages
    @throws InputError  when references or points do not fit the model, or none of its modes is found
    [worker] Docs/Theory.md, section 8.7. */
RetunedModel retune (const ModalModel& model, const FrequencyResponses& responses, const IdentificationOptions&);
} // namespace antinode
