#pragma once

#include "PlayedRecording.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

namespace antinode
{
/** Relative standard deviations of a device from its model, by mode. What is known before anything is played. */
struct ModeSpread
{
    Eigen::VectorXd frequencies, dampings, participation; ///< N_m each.
    double atNodes = 0; ///< Of the deviation of a mode's RMS participation, what one has that the model has none of.
    double drift = 0;   ///< Of a factor that all frequencies share.
    double gain = 0;    ///< Of a factor that all participations share.
    double ceramicGains = 0; ///< Of a factor of each ceramic's participations.
    double mixing = 0;       ///< Of what couples two modes, relative to their stiffness: they are each other's mixture.
    bool mixesForces = true; ///< Whether participations are mixed, too, or were measured.
    double delay = 20e-6;    ///< Of each recording's delay, s.
    double distortion = 0.02; ///< Of each ceramic's cubic distortion at its largest voltage; 0: ceramics are linear.
};

/** The same deviations for every mode. [any] */
inline ModeSpread sameSpread (Eigen::Index modes, double frequency, double damping, double participation)
{
    return { Eigen::VectorXd::Constant (modes, frequency), Eigen::VectorXd::Constant (modes, damping),
             Eigen::VectorXd::Constant (modes, participation) };
}

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
