#pragma once

#include "LearnModes.h"

namespace antinode
{
/** The linear device that moves like a learnt one at an instant, while such voltages are played: of all changes of the
    participations the least one that gives each mode what its distorting ceramics add. A design with it needs no other
    calculation than one for linear ceramics; it is right for voltages near these.
    @param voltages  N_b x N_s, V, of the sample rate
    @param time      s, from their beginning: of the focus
    @return          the learnt model where no ceramic distorts
    [worker] Docs/Theory.md, section 7.6. */
ModalModel equivalentLinear (const LearntModes&, const Eigen::MatrixXd& voltages, double sampleRate, double time);

/** Cubic distortion c U^2 of each ceramic at its largest voltage: N_b.
    @param distortions  c, N_b, 1/V^2
    @param voltages     N_b x N_s, V
    [any] */
Eigen::VectorXd distortionShares (const Eigen::VectorXd& distortions, const Eigen::MatrixXd& voltages);
} // namespace antinode
