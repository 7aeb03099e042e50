#pragma once

#include <Eigen/Core>

namespace antinode
{
/** The cubes of band-limited voltages, without what they have beyond half the sample rate: what ceramics that distort
    add to their motion.
    @param voltages  V, N_b x N_s
    @return          V^3, N_b x N_s
    [worker] Docs/Theory.md, section 7.6. */
Eigen::MatrixXd cubedVoltages (const Eigen::MatrixXd& voltages);
} // namespace antinode
