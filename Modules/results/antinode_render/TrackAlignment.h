#pragma once

#include <Eigen/Core>

namespace antinode
{
/** When tracks begin in what was played. */
struct TrackAlignment
{
    Eigen::Index begin = 0; ///< The sample of the trigger.
    double likeness = 0;    ///< Correlation of reached and wanted motions there, all points as one signal: -1 to 1.
};

/** The sample at which wanted motions are most like what was reached, the same for all points.
    @param reached  points x N_s, m
    @param wanted   N_w x points, m, at the same rate; not all 0
    [worker] */
TrackAlignment alignTracks (const Eigen::MatrixXd& reached, const Eigen::MatrixXd& wanted);
} // namespace antinode
