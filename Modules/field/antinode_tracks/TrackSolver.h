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

/** The sum of products. */
inline double product (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.cwiseProduct (b).sum();
}

struct GradientsResult
{
    Eigen::MatrixXd solution;
    Eigen::MatrixXd pulls; ///< G' x
    Eigen::MatrixXd left;  ///< Of right.
    int iterations = 0;
};

inline constexpr int maximumGradients = 400; ///< Iterations of conjugate gradients for one system.

/** (G D G' + lambda) x = right by preconditioned conjugate gradients, D the samples that are free to move.
    @param free       window x actuators, 1 or 0
    @param tolerance  of the norm of what is left of right
    @param most       iterations
    @throws Cancelled  when a watch of this thread says no
    [worker] */
GradientsResult solveByGradients (WindowedResponses&, const Eigen::MatrixXd& free, const Eigen::MatrixXd& right,
                                  double tolerance, int most = maximumGradients);

/** Where the dual stands. */
struct TrackPoint
{
    Eigen::MatrixXd multipliers, pulls, voltages;
    Eigen::MatrixXd slope; ///< What the wanted motion misses: w - G u - lambda z.
};

/** The dual of the least squares within limits, with the compliance that the responses have when it is asked.
    Docs/Theory.md, section 4.13. Keeps references to what it is made of. */
class LimitedDual
{
public:
    /** @param wanted  length x points, m @param limits  V, one per actuator, above 0 [worker] */
    LimitedDual (WindowedResponses&, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits);

    /** The point of some multipliers, whose pulls are known. [worker] */
    TrackPoint pointAt (Eigen::MatrixXd multipliers, Eigen::MatrixXd pulls) const;

    /** V^2: each sample's part is v f - v^2 / 2 with v = clip (f). [worker] */
    double value (const TrackPoint&) const;

    /** The slope along a direction, whose pulls are known. [worker] */
    double slopeAlong (const TrackPoint&, const Eigen::MatrixXd& step, const Eigen::MatrixXd& change,
                       double length) const;

    /** From w'z = (w - G u)' z + u' G' z for any u within the limits: the least ||G u - w|| / ||w||. [worker] */
    double errorBound (const TrackPoint&) const;

    /** w - G u, m. [worker] */
    Eigen::MatrixXd missing (const TrackPoint&) const;

    /** 1 for the samples within the limits, 0 for those at them. [worker] */
    Eigen::MatrixXd freeSamples (const TrackPoint&) const;

    /** ||w|| [any] */
    double size() const { return wanted.norm(); }

private:
    Eigen::MatrixXd clipped (const Eigen::MatrixXd& pulls) const { return pulls.cwiseMin (bounds).cwiseMax (-bounds); }

    WindowedResponses& responses;
    const Eigen::MatrixXd& wanted;
    Eigen::MatrixXd bounds;
};

/** A way up the dual. */
struct LimitedClimb
{
    TrackPoint point;
    double errorBound = 0;
    int iterations = 0;
};

/** Semismooth Newton steps from where a climb stands until the slope is less than a share of the wanted motion.
    @param uselessError  where errorBound is above that it ends early
    @throws Cancelled  when a watch of this thread says no
    [worker] */
void climbLimited (WindowedResponses&, const LimitedDual&, LimitedClimb&, double tolerance, double uselessError = 1);
} // namespace antinode
