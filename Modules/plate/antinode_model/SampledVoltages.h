#pragma once

#include "Playback.h"

#include <Eigen/Core>

namespace antinode
{
/** Voltages of any form as samples, made for one way of playing them. Before the first and after the last they are 0.
 */
struct SampledVoltages
{
    Playback playback;      ///< The only one at which they do what they were designed for; with a rate of more than 0.
    double firstTime = 0;   ///< s from the trigger: when the first sample is played.
    Eigen::MatrixXd values; ///< N_b x N_s, V.
};
} // namespace antinode
