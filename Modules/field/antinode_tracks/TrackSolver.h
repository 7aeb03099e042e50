#pragma once

#include "WindowedResponses.h"

#include <Eigen/Core>

namespace antinode
{
/** Voltages within limits that move points as wanted, as well as that is possible.

        minimise    1/2 ||u||^2 + ||G u - w||^2 / (2 lambda)     subject to   |u (n, i)| <= limits (i)

    with lambda the compliance of G. Docs/Theory.md, section 4.13. */
struct TrackSolution
{
    Eigen::MatrixXd voltages;    ///< window x actuators, V: within the limits to the last bit.
    Eigen::MatrixXd multipliers; ///< length x points.
    double error = 0;            ///< ||G u - w|| / ||w||
    double objective = 0;        ///< What is minimised, V^2.
    double bound = 0;            ///< No voltages within the limits have less (weak duality).
    double errorBound = 0;       ///< No voltages within the limits leave a smaller error.
    int iterations = 0;          ///< Of conjugate gradients, in all.
};

/** The least-norm voltages without limits: conjugate gradients on the dual, (G G' + lambda) z = w.
    @param wanted  length x points, m
    @throws Cancelled  when a watch of this thread says no
    [worker] */
TrackSolution solveTracks (WindowedResponses&, const Eigen::MatrixXd& wanted);

/** The same within limits: semismooth Newton steps on the dual, u = clip (G' z), each by conjugate gradients.
    @param limits       V, one per actuator, above 0
    @param start        multipliers to start from: those of a solution nearby
    @param uselessError where errorBound is above that it ends early, far from the optimum
    [worker] */
TrackSolution solveLimitedTracks (WindowedResponses&, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                                  const Eigen::MatrixXd& start, double uselessError = 1);

/** No voltages that reach an error have a smaller max |u (n, i)| / limits (i) than this: from z and any u,
    w'z - error ||w|| ||z|| <= u' G' z. @param multipliers  any: those of a solution prove most [worker] */
double peakBound (WindowedResponses&, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                  const Eigen::MatrixXd& multipliers, double error);
} // namespace antinode
