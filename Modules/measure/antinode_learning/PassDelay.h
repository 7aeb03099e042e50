#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Signals without the delay that they came with. */
struct AlignedSignals
{
    Eigen::MatrixXd signals; ///< N x N_s: the last ones, of the length of the delay, are not known and 0.
    double delay = 0;        ///< s
};

/** Signals that were recorded some time after what a model predicts of them, moved to where they correlate most with
    it.
    @param signals       N x N_s
    @param predicted     N x N_p, without delay, of the same rate
    @param longestDelay  s, that is looked for
    @throws InputError   when the numbers of rows differ, or nothing is predicted or recorded
    [worker] Docs/Theory.md, sections 4.15 and 7.6. */
AlignedSignals alignedWith (const Eigen::MatrixXd& signals, const Eigen::MatrixXd& predicted, double sampleRate,
                            double longestDelay);
} // namespace antinode
