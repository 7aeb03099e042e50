#include "LeastPeak.h"

#include "TrackSolver.h"

#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double peakTolerance = 3e-3; // of the wanted motion, a tenth of the errors that are looked for
constexpr double aimedAt = 0.96;       // of the error: a search from both sides ends below it
constexpr double nearEnough = 0.9;
constexpr double noLimit = 1e30; // times the limits

/** A limit on all voltages and the error that it leaves; a peak of 0: none yet. */
struct PeakTrial
{
    double peak = 0, error = 0;
};

/** The least error within a peak, at the compliance of the responses. */
LeastPeak withinPeak (WindowedResponses& responses, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                      double error, double peak, const Eigen::MatrixXd& start)
{
    const LimitedDual dual (responses, wanted, peak * limits);
    LimitedClimb climb { dual.pointAt (start, responses.pulls (start)) };
    climbLimited (responses, dual, climb, peakTolerance);
    LeastPeak found;
    found.error = dual.missing (climb.point).norm() / wanted.norm();
    found.bound = peakBound (responses, wanted, limits, climb.point.multipliers, error);
    found.compliance = responses.compliance();
    found.peak = peak;
    found.iterations = climb.iterations;
    found.voltages = std::move (climb.point.voltages);
    found.multipliers = std::move (climb.point.multipliers);
    return found;
}

/** Whether a peak is known that leaves the error and is not much larger than needed. */
bool isBetween (const PeakTrial& below, const PeakTrial& above, double error)
{
    constexpr double asNear = 1.005;
    return above.peak > 0
           && (above.error >= nearEnough * error || (below.peak > 0 && above.peak < asNear * below.peak));
}

/** Where the error would be the one that is aimed at: between a peak below and one above by a power law through both,
    beyond the only one by the law that errors have near the least peak, with short steps. */
double nextPeak (const PeakTrial& below, const PeakTrial& above, double error)
{
    constexpr double usualPower = -8, longest = 0.3, inside = 0.1;
    const auto aim = std::log (aimedAt * error);

    if (below.peak > 0 && above.peak > 0)
    {
        const auto share = (aim - std::log (above.error)) / std::log (below.error / above.error);
        return above.peak * std::pow (below.peak / above.peak, std::clamp (share, inside, 1 - inside));
    }

    const auto& only = below.peak > 0 ? below : above;
    return only.peak * std::exp (std::clamp ((aim - std::log (only.error)) / usualPower, -longest, longest));
}
} // namespace

LeastPeak softestPeak (WindowedResponses& responses, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                       double error)
{
    constexpr double softest = 1e6, step = 4, wellBelow = 0.8;
    const auto compliance = responses.compliance();
    LeastPeak found;
    found.multipliers = Eigen::MatrixXd::Zero (wanted.rows(), wanted.cols());
    found.error = 1;
    auto iterations = 0;

    for (auto softer = softest; softer >= 1 && found.error > wellBelow * error; softer /= step)
    {
        responses.setCompliance (softer * compliance);
        found = withinPeak (responses, wanted, limits, error, noLimit, step * found.multipliers);
        iterations += found.iterations;
    }

    found.peak = (found.voltages.cwiseAbs() * limits.cwiseInverse().asDiagonal()).maxCoeff();
    found.iterations = iterations;
    responses.setCompliance (compliance);
    return found;
}

LeastPeak lowerPeak (WindowedResponses& responses, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                     double error, const LeastPeak& from)
{
    constexpr double step = 4, nearer = 0.7; // of the way from the peak to its bound, in ratios
    auto start = from;
    start.compliance /= step;
    start.multipliers *= step;
    start.peak = from.bound > 0 ? from.peak * std::pow (from.bound / from.peak, nearer) : from.peak / 2;
    return peakThere (responses, wanted, limits, error, start);
}

LeastPeak peakThere (WindowedResponses& responses, const Eigen::MatrixXd& wanted, const Eigen::VectorXd& limits,
                     double error, const LeastPeak& from)
{
    constexpr int trials = 10;
    const auto compliance = responses.compliance();
    responses.setCompliance (from.compliance);
    auto best = from, last = from;
    best.error = 1;
    best.iterations = 0;
    PeakTrial below, above;

    for (int i = 0; i < trials && ! isBetween (below, above, error); ++i)
    {
        const auto peak = i > 0 ? nextPeak (below, above, error) : from.peak;
        last = withinPeak (responses, wanted, limits, error, peak, last.multipliers);
        last.bound = std::max (best.bound, last.bound);
        last.iterations += best.iterations;
        (last.error <= error ? above : below) = { last.peak, last.error };

        if (last.error <= error)
            best = last;

        best.bound = last.bound;
        best.iterations = last.iterations;
    }

    responses.setCompliance (compliance);
    return best;
}

namespace
{
constexpr double closed = 1.07; // the peak over its bound: lower peaks are not looked for
constexpr int mostStages = 5;   // of a quarter of lambda each

/** Keeps voltages if they leave an error that is accepted and need less of the limits than those before. */
void keepIfLower (TrackReach& reach, const TrackWork& work, const Eigen::MatrixXd& voltages, double error,
                  double acceptedError)
{
    if (error > acceptedError)
        return;

    auto played = interpolated (voltages, work.span.factor);

    if (const auto times = timesLimits (work, played); reach.times <= 0 || times < reach.times)
    {
        reach.played = std::move (played);
        reach.span = work.span;
        reach.times = times;
        reach.error = error;
    }
}
} // namespace

TrackReach reachOf (const ModalModel& model, const WaveformsDescription& description, TrackWork& work,
                    const TrackSolution& unlimited)
{
    constexpr double aboveLeastNorm = 1.1;
    const auto error = std::max (acceptedTrackError, aboveLeastNorm * unlimited.error);
    TrackReach reach;
    keepIfLower (reach, work, unlimited.voltages, unlimited.error, error);
    auto lowest = softestPeak (work.responses, work.wanted, work.limits, error);

    const auto keep = [&] (const TrackWork& from)
    {
        keepIfLower (reach, from, lowest.voltages, lowest.error, error);
        reach.bound = std::max (reach.bound, lowest.bound);
        reach.iterations += lowest.iterations;
    };
    keep (work);

    // Lower peaks are steeper: where slew rates decide, the soft voltages are the best.
    for (int i = 0;
         i < mostStages && reach.times > 1 && lowest.peak > closed * lowest.bound && ! isSteep (work, reach.played);
         ++i)
    {
        lowest = lowerPeak (work.responses, work.wanted, work.limits, error, lowest);
        keep (work);
    }

    if (reach.times <= std::max (1.0, closed * lowest.peak) || isSteep (work, reach.played))
        return reach;

    if (auto fine = finerWork (model, description, work))
    {
        lowest.multipliers = finer (lowest.multipliers, work.span.factor / fine->span.factor);
        lowest.bound = 0;
        lowest = peakThere (fine->responses, fine->wanted, fine->limits, error, lowest);
        keep (*fine);
    }

    return reach;
}
} // namespace antinode
