#pragma once

#include <Eigen/Core>

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
} // namespace antinode
