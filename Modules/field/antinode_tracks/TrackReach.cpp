#include "TrackReach.h"

#include "LeastPeak.h"

#include <antinode_numerics/SampleInterpolation.h>

#include <algorithm>
#include <utility>

namespace antinode
{
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
