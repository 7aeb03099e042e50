#pragma once

#include "LearnModes.h"

#include <vector>

namespace antinode
{
/** What sensors hear until the voltages have ended, of what a model predicts of it: RMS, the median of the sensors.
    [worker] */
double loudnessOf (const ModalModel&, const std::vector<Sensor>&, const PlayedRecording&);

/** The model whose response is the mean response of devices with scattered frequencies: their phases drift apart, which
    acts like more damping.
    @param frequencyDeviations  N_m, relative
    [any] */
ModalModel meanModel (ModalModel, const Eigen::VectorXd& frequencyDeviations);

/** At most so many delays that a recording may have, by what a model predicts of it, s: the most likely one first; its
    own where that is known. [worker] Docs/Theory.md, section 7.6. */
std::vector<double> delaysBy (const ModalModel&, const std::vector<Sensor>&, const PlayedRecording&, std::size_t most);

/** The same recording with a delay that is known, s. [any] */
PlayedRecording withDelay (PlayedRecording, double delay);

/** RMS of what a device does not predict of a recording, of the noise, by the delay that suits this device best: within
    a few deviations of its own, or where it is looked for.
    @throws InputError, Cancelled  as learnModes
    [worker] Docs/Theory.md, section 7.6. */
double surprise (const LearntModes&, const ModeSpread&, const PlayedRecording&);
} // namespace antinode
