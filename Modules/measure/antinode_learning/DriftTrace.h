#pragma once

#include "FollowDrift.h"

#include <functional>
#include <vector>

namespace antinode
{
/** What was known of a device's frequencies at one time. */
struct DriftMoment
{
    double time = 0; ///< s, of the window's end from the recording's beginning.
    DriftState state = DriftState::silent;
    double unexplained = 0, jump = 0; ///< As FollowedDrift.
    std::string reason;
    Eigen::VectorXd frequencies; ///< N_m: relative changes from the model.
    Eigen::VectorXd deviations;  ///< N_m: of these, standard deviations.
    double common = 0;           ///< The mean of the changes, each weighted by the inverse of its variance.
};

/** A drift as a recording shows it, window by window. */
struct DriftTrace
{
    std::vector<DriftMoment> moments;
    DriftEstimate estimate; ///< In the end.
};

/** The moment of a step. [any] */
DriftMoment momentOf (const FollowedDrift&, const DriftLayout&, double time);

/** Follows a long recording, below the highest mode of the model, window by window, each with the memory of the one
   before.
    @param window    s, that are compared at once
    @param progress  is told the share that is done
    @throws InputError  as followDrift, or where the recording is shorter than memory and one window; Cancelled as
   checkWatch()
    [worker] Docs/Theory.md, section 7.7. */
DriftTrace followRecording (const ModalModel& nominal, const std::vector<Sensor>&, const PlayedRecording&,
                            const DriftSettings&, double window, const std::function<void (double)>& progress = {});
} // namespace antinode
