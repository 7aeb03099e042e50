#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The nonlinear part of the sensor signals, RMS values relative to the linear response within the band. */
struct NonlinearDistortion
{
    double even = 0, odd = 0;      ///< Of a multisine with an odd grid, noise taken out; else 0.
    std::vector<double> harmonics; ///< Of a sweep: the second, the third, ...; else empty.
};

/** Responses of N sensors to one ceramic, on N_f lines. */
struct EstimatedResponses
{
    Eigen::MatrixXcd values;   ///< N_f x N: output per input with exp (+i omega t).
    Eigen::MatrixXd variances; ///< N_f x N: E |error|^2; empty if one period alone cannot tell.
    Eigen::MatrixXd
        coherence; ///< N_f x N: 0 to 1, the share of a block's power that comes from the input; empty in the same case.
    std::vector<NonlinearDistortion> distortion; ///< One per sensor; empty if the excitation does not show it.
};

/** Variances that few repetitions tell: each becomes the mean of itself and four neighbours at each side, within which
   a resonance hardly changes. @param variances  N_f x N [worker] */
Eigen::MatrixXd averagedOverNeighbours (const Eigen::MatrixXd& variances);
} // namespace antinode
