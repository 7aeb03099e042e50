#pragma once

#include "TrackSolver.h"
#include "TrackWork.h"
#include "WindowedResponses.h"

#include <Eigen/Core>

namespace antinode
{
/** Voltages that leave an error, with a peak near the least that does. Docs/Theory.md, section 4.13. */
struct LeastPeak
{
    Eigen::MatrixXd voltages;    ///< window x actuators, V
    Eigen::MatrixXd multipliers; ///< length x points, of the dual.
    double compliance = 0;       ///< lambda at which they were found, m^2/V^2: the lower, the nearer peak and bound.
    double peak = 0;             ///< max |u (n, i)| / limits (i)
    double bound = 0;            ///< No voltages of any form that leave this error have a smaller peak.
    double error = 0;            ///< ||G u - w|| / ||w||
    int iterations = 0;          ///< Of conjugate gradients, in all.
};

/** The least voltages without a limit that leave less than an error: where the way to the least peak begins. What peak
    they need depends on lambda, which falls from 10^6 times that of the responses until the error is small enough.
    @param limits  V, one per actuator, above 0: the peak is counted in these
    @param error   ||G u - w|| / ||w||, above that of the least-norm voltages
    @throws Cancelled  when a watch of this thread says no
    [worker] */
LeastPeak softestPeak (WindowedResponses&, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits, double error);

/** The next on the way: lambda is a quarter, the peak falls until the error is near the given one from below. The gap
    between peak and bound falls with it, by about five. @param from  the one before [worker] */
LeastPeak lowerPeak (WindowedResponses&, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits, double error,
                     const LeastPeak& from);

/** The same lambda with responses at another rate, or the same once more: the peak that keeps the error.
    @param from  multipliers at the rate of these responses [worker] */
LeastPeak peakThere (WindowedResponses&, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits, double error,
                     const LeastPeak& from);

/** Voltages that leave an error that is accepted with near the least share of the limits. A level only scales them, so
    they say which levels can be reached. */
struct TrackReach
{
    Eigen::MatrixXd played; ///< samples x actuators, V: at the wanted level, within the limits or not.
    TrackSpan span;         ///< Of the design that they are from.
    double times = 0;       ///< How many times the limits they need.
    double bound = 0;       ///< None of any form that leave this error need less.
    double error = 0;       ///< ||reached - wanted|| / ||wanted||
    int iterations = 0;     ///< Of conjugate gradients, in all.
};

/** Looks for voltages that leave at most acceptedTrackError, or a tenth more than the least-norm ones where these leave
    more. It ends where they keep the limits, or where a bound says that they cannot be much lower.
    @param work       at its own rate; where what is played passes the limits between samples, it goes on at that rate
    @param unlimited  the least-norm voltages
    @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Design/tracks.md. */
TrackReach reachOf (const ModalModel&, const WaveformsDescription&, TrackWork& work, const TrackSolution& unlimited);
} // namespace antinode
