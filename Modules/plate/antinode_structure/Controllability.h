#pragma once

#include <Eigen/Core>

namespace antinode
{
/** The correlation of the velocity responses of modes to past voltages: H_kl = integral over 0..T of h_k h_l, h_k the
   velocity that mode k has a time tau after a unit impulse of force. Ceramic i then brings diag(alpha_i) H
   diag(alpha_i) to the Gramian of the velocities that can be reached at T.
    @param angularFrequencies, dampingRatios  N_m each, rad/s and less than 1
    @param duration                           T, s
    @return                                   N_m x N_m, s
    [worker] Docs/Theory.md, section 1.9. */
Eigen::MatrixXd velocityKernel (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                                double duration);

/** The Gramian's worst direction: the least eigenvalue of sum_i diag(alpha_i) H diag(alpha_i). Its inverse is the
   largest energy, in V^2 s, that one unit of modal velocity can cost.
    @param kernel         N_m x N_m, scaled to what the modes are wanted for
    @param participation  N_m x ceramics
    [worker] Docs/Theory.md, section 1.9. */
double worstControllability (const Eigen::MatrixXd& kernel, const Eigen::MatrixXd& participation);
} // namespace antinode
