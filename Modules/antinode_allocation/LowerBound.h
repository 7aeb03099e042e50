#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Modal velocities to be reached from rest, by voltages of any waveform. N_k modes, N_b ceramics. */
struct WaveformBoundProblem
{
    Eigen::VectorXcd poles;        ///< N_k: s_k = -a_k + j b_k, 1/s, a_k >= 0, b_k > 0.
    Eigen::MatrixXd participation; ///< N_k x N_b, N kg^-1/2 / V.
    Eigen::VectorXd wanted;        ///< N_k: q'_k at the end, m/s kg^1/2.
    Eigen::VectorXd voltageLimits; ///< N_b, V, more than 0.
    double duration = 0;           ///< t_f, s, more than 0.
};

/** A certified lower bound of max |u_i (t)| / voltageLimits (i) over all waveforms on [0, t_f] that bring the modes from rest to the
    wanted velocities. With h_k (tau) = e^{-a tau} (cos b tau - a/b sin b tau), the velocity after an impulse, and any y

        max |u_i| / limit_i >= sum_k wanted_k y_k / sum_i limit_i integral_0^t_f |f_i|,   f_i (tau) = sum_k y_k participation_ki h_k (tau)

    y are the multipliers of the least peak of samples, 8 a cycle of the fastest mode and at most 20000, within 0.5 % (BoundedWaveform.h);
    that it is not the best costs tightness, not truth. The integrals are bounded
    from above on a grid of 0.15 rad of the fastest mode: cells in which f_i certainly keeps its sign by its antiderivative, others by
    the chord and (step^3 / 12) max |f_i''|, the largest that a chord can miss. So the bound holds for the continuous waveform.
    @return  a ratio, 0 where nothing is wanted
    @throws InputError  when sizes or numbers are not usable, or no ceramic moves a wanted mode
    [worker] Docs/Theory.md, section 4. */
double anyWaveformPeakBound (const WaveformBoundProblem&);
} // namespace antinode
