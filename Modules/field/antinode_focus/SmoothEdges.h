#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/SampledVoltages.h>

namespace antinode
{
/** Each sample follows a free one by a low-pass of first order, from rest: so many free samples are its time constant.
   A jump becomes an edge, and limits that the free samples keep are kept.
    @param samples       N_b x N_s
    @param timeConstant  0: the samples as they are
    [any] Docs/Theory.md, section 4.9. */
Eigen::MatrixXd withSmoothEdges (const Eigen::MatrixXd& samples, double timeConstant);

/** The adjoint: what values for each smooth sample are for each free one.
    @param weights  any x N_s; where it is moved, it is the result
    [any] */
Eigen::MatrixXd smoothEdgesAdjoint (Eigen::MatrixXd weights, double timeConstant);

/** dU/dt of what band-limited samples stand for, V/s, from the rest before them to the rest behind. */
struct SampledSlopes
{
    Eigen::MatrixXd values;     ///< N_b x N, at 8 places per sample.
    double first = 0, last = 0; ///< s from the trigger: the times of the first and the last one.
};

/** [worker] */
SampledSlopes slopesOf (const SampledVoltages&);

/** The same samples up to those that act before the focus, and then a fade to 0 that keeps the slew limits.
    @param slewLimits  N_b, V/s; 0: none
    [any] */
SampledVoltages withSlowEnd (const SampledVoltages&, const Eigen::VectorXd& slewLimits, double focusTime);
} // namespace antinode
