#pragma once

#include "SkinThreshold.h"

#include <Eigen/Core>

namespace antinode
{
/** A displacement as skin weighs it: each frequency is divided by the threshold, without a shift in time; what rests is
   not felt.
    @param displacement  N_s samples, m, at rest before and after
    @return              N_s, times the threshold
    [worker] Docs/Theory.md, section 5.1. */
Eigen::RowVectorXd feltDisplacement (const Eigen::VectorXd& displacement, double sampleRate, const SkinThreshold&);
} // namespace antinode
