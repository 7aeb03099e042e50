#pragma once

#include <antinode_model/ModalModel.h>

#include <optional>

namespace antinode
{
/** New frequencies and dampings of some of a model's modes. N_m modes. */
struct ModeUpdate
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m: where known.
    std::vector<bool> isKnown;                         ///< N_m
};

/** The model with what is known put in. The frequency of other modes moves by the mean relative change of a few known
    neighbours on either side, interpolated; their damping stays, and so does the order of modes.
    [worker] Docs/Theory.md, section 8.7. */
ModalModel updated (ModalModel, const ModeUpdate&);

/** By how much frequencies of a device usually differ from those that a solver computes, relative; none where they were
   measured. [any] */
std::optional<double> usualModelError (const ModalModel&);

/** Some modes of a model, in the order that is given. [worker] */
ModalModel withModes (ModalModel, const std::vector<Eigen::Index>& modes);

/** The model with its modes in ascending order of frequency. [worker] */
ModalModel ascending (ModalModel);
} // namespace antinode
