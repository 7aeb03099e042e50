#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Modes as they are known before a measurement, at its points. N_m modes, N_p points, N_b references. */
struct KnownModes
{
    Eigen::VectorXd angularFrequencies; ///< N_m: rad/s, ascending.
    Eigen::VectorXd dampingRatios;      ///< N_m
    Eigen::MatrixXd shapes;             ///< N_p x N_m: kg^-1/2
    Eigen::MatrixXd participation;      ///< N_m x N_b: N kg^-1/2 / V

    Eigen::Index modes() const { return angularFrequencies.size(); }
};

/** Standard deviations of known modes from what is measured, relative. */
struct KnownSpread
{
    double frequency = 0.02;     ///< Of each frequency.
    double damping = 0.3;        ///< Of each damping ratio.
    double participation = 0.05; ///< Of each participation, beside a factor of each ceramic.
    double drift = 0.03;         ///< Of a factor that all frequencies share.
};
} // namespace antinode
