#pragma once

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** New frequencies and dampings of some of a model's modes. N_m modes. */
struct ModeUpdate
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m: where known.
    std::vector<bool> isKnown;                         ///< N_m
};

/** The model with what is known put in; the frequency of other modes moves by the mean relative change of a few known
    neighbours on either side, interpolated, and their damping stays. The order of modes stays. [worker] Docs/Theory.md,
   section 8.7. */
ModalModel updated (ModalModel, const ModeUpdate&);

/** The model with its modes in ascending order of frequency. [worker] */
ModalModel ascending (ModalModel);
} // namespace antinode
