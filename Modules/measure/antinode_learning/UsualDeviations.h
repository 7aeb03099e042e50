#pragma once

#include "ModeSpread.h"
#include "PlayedRecording.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** How far a device usually is from its model, by where its modes come from: each mode of its own, and gains, drift and
    mixtures of neighbours in common. [any] Docs/Theory.md, section 7.6. */
ModeSpread usualDeviations (const ModalModel&);

/** A velocity sensor at a place, and how well the model's origin lets it know what the sensor hears.
    @param placeDeviation  m, of each of its coordinates; 0: the place is exact
    @throws InputError  as shapesAt
    [worker] Docs/Theory.md, section 7.6. */
Sensor sensorAt (const ModalModel&, double x, double y, double placeDeviation);

/** A ceramic without voltage, whose current is heard: as its participations.
    @param deviation  relative, of each
    [any] */
Sensor idleCeramic (const ModalModel&, Eigen::Index ceramic, double deviation);

/** How much of its neighbours a mode may be on a device whose stiffness is a little another: N_m, by perturbation
    theory.
    @param mixing  as ModeSpread::mixing
    [any] */
Eigen::VectorXd mixturesOf (const Eigen::VectorXd& angularFrequencies, Eigen::Index mode, double mixing);

/** The same without the modes before and after it. [any] */
Eigen::VectorXd farMixturesOf (const Eigen::VectorXd& angularFrequencies, Eigen::Index mode, double mixing);
} // namespace antinode
