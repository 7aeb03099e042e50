#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** What listens to the surface: a velocity sensor at a place, or an idle ceramic whose current is measured. */
struct Sensor
{
    Eigen::RowVectorXd shapes; ///< N_m: its signal per modal velocity; of a velocity sensor the mode shapes there.
    Eigen::RowVectorXd deviations = {}; ///< N_m: standard deviation of each of these; none: they are known.
    double gain = 0;                    ///< Relative standard deviation of a factor of all of them.
    Eigen::Matrix2Xd slopes = {}; ///< 2 x N_m: what a standard deviation of its place, along x and y, changes of them;
                                  ///< none: the place is exact.
};

/** Voltages that were played on a surface at rest, and what the sensors recorded meanwhile. */
struct PlayedRecording
{
    double sampleRate = 0;      ///< Hz
    Eigen::MatrixXd voltages;   ///< N_b x N_s, V.
    Eigen::MatrixXd signals;    ///< N x N_s, in the unit of the sensors' shapes times modal velocities.
    Eigen::VectorXd noise;      ///< N: standard deviation of each sensor's samples.
    double delay = 0;           ///< s, from the voltages to the signals, as far as it is known.
    double delaySpan = 0;       ///< s: by how much the delay may be longer; it is then looked for. 0: it is known.
    double bandShare = 1;       ///< Of the frequencies up to half the rate: where the noise lies, at its known density.
    Eigen::MatrixXd cubes = {}; ///< N_b x N_s, V^3: of the voltages, as cubedVoltages; none: ceramics are linear.
};
} // namespace antinode
