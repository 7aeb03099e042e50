#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Signals at a rate that is a whole multiple of theirs: what their samples stand for, from kaiserSincHalfWidth samples
    before the first one to as many behind the last.
    @param signals  N_s x any number, one a column
    @param factor   at least 1
    @return         (N_s - 1 + 2 kaiserSincHalfWidth) factor + 1 samples each
    [worker] */
Eigen::MatrixXd interpolated (const Eigen::MatrixXd& signals, Eigen::Index factor);

/** The adjoint of interpolated(): what values for each sample of its result are for each sample that it is made from.
    @param values  (N_s - 1 + 2 kaiserSincHalfWidth) factor + 1 x any number, one a column
    @param factor  at least 1
    @return        N_s x as many
    [worker] */
Eigen::MatrixXd interpolationAdjoint (const Eigen::MatrixXd& values, Eigen::Index factor);
} // namespace antinode
