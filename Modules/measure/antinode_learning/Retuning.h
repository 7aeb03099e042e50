#pragma once

#include <antinode_identification/FrequencyResponses.h>
#include <antinode_identification/KnownModes.h>
#include <antinode_model/ModalModel.h>

namespace antinode
{
/** A known device after a drift, and what has changed, in the order of the modes before. N_m modes, N_b ceramics. */
struct RetunedModel
{
    ModalModel model;                 ///< Frequencies, dampings and participation updated, shapes only as mixtures of
                                      ///< neighbours; its modes in ascending order of their new frequencies.
    std::vector<bool> found;          ///< N_m: whether the mode was seen; others moved with their neighbours.
    Eigen::VectorXd frequencyChanges; ///< N_m: relative.
    Eigen::VectorXd dampingChanges;   ///< N_m: relative.
    Eigen::VectorXd frequencyDeviations, dampingDeviations,
        participationDeviations; ///< N_m: standard deviations that are left, relative.
    Eigen::VectorXd
        participationScales;        ///< N_b: by which each ceramic's participation was multiplied; 1 where not seen.
    Eigen::VectorXd pointErrors;    ///< N_p: what is left of each point's responses, RMS over RMS.
    double delay = 0;               ///< s
    bool hasExactShapes = false;    ///< Shapes and places of points were not fitted: of a model that does not say where
                                    ///< its modes come from, of more than 30 points, of more than 4000 unknowns.
    double reconstructionError = 0; ///< dB, of the few responses.
};

/** Updates frequencies, damping and participation of a known device from the responses of a few points: the most
    probable ones, given what is measured and how far devices differ from their model. Of a model that says where its
    modes come from, shapes at the points are uncertain, too, as usualDeviations() has them.
    @param model           as it was known; its ceramics are the references, in their order
    @param responses       at points on the model's surface, driven by voltages
    @param placeDeviation  m, of each coordinate of each point
    @throws InputError  when references or points do not fit the model, or none of its modes is found
    [worker] Docs/Theory.md, section 8.7. */
RetunedModel retune (const ModalModel& model, const FrequencyResponses& responses, const KnownSpread&,
                     double placeDeviation = 0);
} // namespace antinode
