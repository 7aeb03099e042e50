#pragma once

#include "ModalModel.h"
#include "VoltageProgram.h"

#include <Eigen/Core>

namespace antinode
{
/** Advances the modes from one sample to the next, exactly for the chosen playback.

    Mode k has the complex state y' = s y + psi, s = -a + jb, T the sample interval, and from the force samples psi_m

        y_k (nT) = transition_k y_k ((n - 1) T) + sum_{l = 0}^{L - 1} taps (k, l) psi_k, n + latency - (L - 1) + l

    so the last tap belongs to the newest sample. Docs/Theory.md, section 6.2. */
struct ModalRecursion
{
    Eigen::ArrayXd transitionReal, transitionImaginary; ///< N_m: e^{sT}
    Eigen::ArrayXXd tapsReal, tapsImaginary;            ///< N_m x L, s
    int latency = 0;                                    ///< Samples.
};

/** The recursion of a model.

    The force between samples is psi (t) = sum_m psi_m K (t/T - m), K the box of a zero-order hold or kaiserSinc, so the
   tap of sample n - 1 + j is T integral_0^1 e^{sT (1 - x)} K (x - j) dx. The integrand is entire in x, so Gauss and
   Legendre's quadrature gives it to rounding, also for modes above the Nyquist frequency: panels are as many as keep
   the phase of each below pi.
    @throws InputError  when the rate is not finite and positive, a frequency or damping ratio is not usable, or a mode
                        lies more than 64 times above the sample rate
    [worker] */
ModalRecursion modalRecursion (const ModalModel&, Playback);

/** Checks the sizes and values of participations and probe shapes.
    @param probeShapes  N_probes x N_c, kg^-1/2
    @throws InputError  when sizes do not agree, or a number is not finite
    [worker] */
void requirePlayable (const ModalModel&, const Eigen::MatrixXd& probeShapes);
} // namespace antinode
