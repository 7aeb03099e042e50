#pragma once

#include <Eigen/Core>

namespace antinode
{
/** The recording of one ceramic's run, from its first sample on. N_s samples, at least those of the signal. */
struct RunRecording
{
    Eigen::MatrixXd sensors;   ///< N x N_s: velocities, m/s.
    Eigen::VectorXd sync;      ///< N_s, any unit; empty if the sync channel was not recorded.
    Eigen::VectorXd reference; ///< N_s: the ceramic's voltage as it was measured, V; empty: as played.
};

/** The scale of recorded samples. */
struct SensorScale
{
    double sensitivity = 0;    ///< mm/s per V; 0: unknown.
    double inputFullScale = 1; ///< Input voltage of a recorded sample of 1, V.

    /** The velocity of a recorded sample of 1, m/s. */
    double fullScaleVelocity() const { return inputFullScale * sensitivity / 1000; }
};
} // namespace antinode
