#pragma once

#include "TrackSolver.h"
#include "TrackWork.h"

namespace antinode
{
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
