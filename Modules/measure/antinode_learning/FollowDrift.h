#pragma once

#include "DriftEstimate.h"

#include <functional>
#include <string>
#include <vector>

namespace antinode
{
enum class DriftState
{
    following, ///< The recording was explained; the estimate is newer.
    silent,    ///< Too little was played to hear anything.
    lost       ///< The recording was not explained: the estimate is as before, and the reason is said.
};

struct DriftSettings
{
    DriftSpread spread;
    double memory = 0.3; ///< s of each recording that are played to bring the modes into motion, but not compared.
    double largestJump = 0.02; ///< Of all frequencies, relative: how far is searched where the signals surprise.
};

/** What one more recording says of a device that drifts. */
struct FollowedDrift
{
    DriftEstimate estimate;
    DriftState state = DriftState::silent;
    double unexplained = 0; ///< RMS of what the model does not explain beyond the noise, of the signals.
    double jump = 0;        ///< The relative change of all frequencies that had to be searched for; 0: none.
    std::string reason;     ///< Why the state is lost, a sentence; else empty.
};

/** The step of a search for a jump: half of the usual half width of a resonance. Relative. [any] */
double jumpStep (const ModalModel&, const DriftSettings&);

/** How many of the lowest modes tell what all frequencies share. [any] */
Eigen::Index modesForSearch (const ModalModel&);

/** Why the signals of a recording cannot be followed whatever was played, a sentence: not finite, or clipped. Ask
   before they are filtered, which hides clipping. Empty: they can. [any] */
std::string signalFault (const PlayedRecording&);

/** Follows the modes of a device by what sensors hear of voltages that are played for whatever reason: one step of an
   iterated Kalman filter, which is Gauss and Newton's method with what was known before as the prior. What the fit
   leaves above the noise counts as noise of its own bandwidth. Where a recording is not explained, a jump of all
   frequencies is searched for; where none explains it, nothing is learnt.
    @param nominal    the model that estimates refer to
    @param sensors    their shapes; deviations are those of the settings' gains
    @param before     what was known at the time of the recording: afterTime()
    @param recording  of a device in motion: its first part is memory; without frequencies of modes that the model does
   not have: atLowerRate()
    @throws InputError  where sizes do not agree, or there are no samples to compare; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 7.7. */
FollowedDrift followDrift (const ModalModel& nominal, const std::vector<Sensor>& sensors, const DriftEstimate& before,
                           const PlayedRecording& recording, const DriftSettings&);

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
