#pragma once

#include "LearnModes.h"

#include <antinode_focus/FocusDesign.h>

#include <optional>

namespace antinode
{
/** A design that keeps what it plays and gets small drives beside it, one for each mode, which add what its field
   lacks. All modes that it hardly drives stay so, however little is known of them. Its brake, if any, stays as it is.
    @param learnt   the device, of N_m modes
    @param missing  N_m: velocities of the modes at the focus that the design lacks, m/s kg^1/2; what modes above .4 of
                    the playback's sample rate lack stays
    @return         none for trains and for programs of samples, and where the limits leave no room
    @throws InputError, Cancelled  as designModes
    [worker] Docs/Theory.md, section 7.6. */
std::optional<FocusDesign> correctedDesign (const FocusDesign&, const ModalModel& learnt,
                                            const Eigen::VectorXd& missing);

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
