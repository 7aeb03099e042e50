#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Local maxima of |voltage| above a threshold each, one list of samples per ceramic: between two zeros only they can
   break a limit.
    @param voltages    N_s x N_b
    @param thresholds  N_b
    [worker] */
std::vector<std::vector<Eigen::Index>> localPeaks (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& thresholds);
} // namespace antinode
