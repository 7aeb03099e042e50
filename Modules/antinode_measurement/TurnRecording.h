#pragma once

#include <Eigen/Core>

namespace antinode
{
/** What was recorded while one ceramic had its turn, from the turn's first sample on. N_s samples, at least those of the turn's signal. */
struct TurnRecording
{
    Eigen::MatrixXd sensors;   ///< N x N_s: velocities, m/s.
    Eigen::VectorXd sync;      ///< N_s, any unit; empty where the sync channel was not recorded.
    Eigen::VectorXd reference; ///< N_s: the ceramic's voltage as it was measured, V; empty: as it was asked for.
};
} // namespace antinode
