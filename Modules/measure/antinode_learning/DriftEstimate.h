#pragma once

#include "PlayedRecording.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** How a device may be off its model, and how quickly that changes: standard deviations of relative changes, those of
   rates after one second of a random walk. */
struct DriftSpread
{
    double drift = 0.005, driftRate = 1e-5;        ///< Of a factor that all frequencies share.
    double frequency = 1e-3, frequencyRate = 1e-6; ///< Of each frequency beside it.
    double damping = 0.1, dampingRate = 1e-4;
    double gain = 0.05, gainRate = 1e-4; ///< Of what each sensor hears of each mode.
    double feedthrough = 0;              ///< What sensors hear of the slope of each voltage, in their unit per V/s;
                                         ///< an idle ceramic hears its neighbours; 0: nothing.
    double delay = 0;                    ///< Of the delay of each sensor, s; 0: it is known.
};

/** What is known of a device that drifts: the most probable values of its parameters and their covariance. The
   parameters are the logarithms of all frequencies, then of all damping ratios, relative to the model's; for each
   sensor in turn the relative gains of all modes; for each sensor the feedthrough of each ceramic; for each sensor the
   delay beyond that of the recording, s. */
struct DriftEstimate
{
    Eigen::VectorXd values; ///< P
    Eigen::MatrixXd factor; ///< P x P: the covariance is this times its transpose.

    /** The standard deviation that is left of a parameter. [any] */
    double deviation (Eigen::Index parameter) const { return factor.row (parameter).norm(); }
};

/** Where parameters stand in an estimate. */
struct DriftLayout
{
    Eigen::Index modes = 0, sensors = 0, ceramics = 0;

    Eigen::Index frequency (Eigen::Index mode) const { return mode; }
    Eigen::Index damping (Eigen::Index mode) const { return modes + mode; }
    Eigen::Index gain (Eigen::Index sensor, Eigen::Index mode) const { return (2 + sensor) * modes + mode; }
    Eigen::Index feedthrough (Eigen::Index sensor, Eigen::Index ceramic) const
    {
        return (2 + sensors) * modes + sensor * ceramics + ceramic;
    }
    Eigen::Index delay (Eigen::Index sensor) const { return feedthrough (sensors, 0) + sensor; }
    Eigen::Index size() const { return delay (sensors); }
};

/** The layout of estimates for a device and so many sensors. [any] */
DriftLayout driftLayout (const ModalModel&, Eigen::Index sensors);

/** What is known before anything was heard: the model, and the deviations from it.
    @throws InputError  where a deviation is negative or not finite
    [worker] Docs/Theory.md, section 7.7. */
DriftEstimate startOfDrift (const DriftLayout&, const DriftSpread&);

/** What is known after some time in which nothing was heard.
    @param elapsed  s, 0 or more
    [worker] */
DriftEstimate afterTime (DriftEstimate, const DriftLayout&, const DriftSpread&, double elapsed);

/** What is known after all frequencies have jumped by a factor: the frequencies are as uncertain as at the start, but
   the factor is known to `left`.
    @param logarithm  of the factor
    [worker] */
DriftEstimate afterJump (DriftEstimate, const DriftLayout&, const DriftSpread&, double logarithm, double left);

/** What is known of the lowest modes alone, for a search: the values, and rows of the factor that say their deviations.
   Modes above answer as springs, which is feedthrough.
    @param layout   of the estimate
    @param count    of modes
    [worker] Docs/Theory.md, section 7.7. */
DriftEstimate estimateOfFirst (const DriftEstimate&, const DriftLayout& layout, const ModalModel& nominal,
                               const std::vector<Sensor>&, Eigen::Index count);

/** The device with the frequencies and damping ratios of an estimate. [worker] */
ModalModel driftedModel (const ModalModel& nominal, const DriftLayout&, const Eigen::VectorXd& values);

/** The change of all frequencies that a device has by an estimate of its lowest modes: those above follow the mean,
   weighted by what is known of each. N_m logarithms. [any] */
Eigen::VectorXd frequencyChanges (const DriftEstimate&, const DriftLayout&, Eigen::Index modes);

/** The device with these changes, and with the damping ratios of the followed modes. [worker] */
ModalModel retunedModel (const ModalModel& nominal, const DriftEstimate&, const DriftLayout&);
} // namespace antinode
