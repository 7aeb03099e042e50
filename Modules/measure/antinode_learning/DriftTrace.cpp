#include "DriftTrace.h"

#include "LowerRate.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
/** A window of a recording with what was played before it, and what it answers later. */
PlayedRecording cut (const PlayedRecording& recording, Eigen::Index first, Eigen::Index count)
{
    return { recording.sampleRate, recording.voltages.middleCols (first, count),
             recording.signals.middleCols (first, count), recording.noise, recording.delay };
}
} // namespace

DriftMoment momentOf (const FollowedDrift& followed, const DriftLayout& layout, double time)
{
    const auto modes = layout.modes;
    DriftMoment moment;
    moment.time = time;
    moment.state = followed.state;
    moment.unexplained = followed.unexplained;
    moment.jump = followed.jump;
    moment.reason = followed.reason;
    moment.frequencies = followed.estimate.values.head (modes).array().exp() - 1;
    moment.deviations = followed.estimate.factor.topRows (modes).rowwise().norm();
    const Eigen::ArrayXd weights = moment.deviations.array().max (1e-12).square().inverse();
    moment.common = (weights * moment.frequencies.array()).sum() / weights.sum();
    return moment;
}

DriftTrace followRecording (const ModalModel& nominal, const std::vector<Sensor>& sensors, const PlayedRecording& whole,
                            const DriftSettings& settings, double window, const std::function<void (double)>& progress)
{
    constexpr double edge = 256; // samples that are lost where a signal is cut
    const auto recording = atLowerRate (whole, highestModelled (nominal));
    const auto rate = recording.sampleRate;
    const auto step = static_cast<Eigen::Index> (std::ceil (window * rate));
    const auto length =
        step + static_cast<Eigen::Index> (std::ceil ((settings.memory + recording.delay) * rate) + edge);

    if (! (window > 0) || recording.voltages.cols() < length)
        throw InputError ("recording", "has " + inWords (static_cast<double> (recording.voltages.cols()) / rate)
                                           + " s; allowed: at least " + inWords (static_cast<double> (length) / rate)
                                           + " s");

    const auto layout = driftLayout (nominal, static_cast<Eigen::Index> (sensors.size()));
    DriftTrace trace { {}, startOfDrift (layout, settings.spread) };
    const auto last = recording.voltages.cols() - length;

    for (Eigen::Index first = 0; first <= last; first += step)
    {
        auto followed = followDrift (nominal, sensors, trace.estimate, cut (recording, first, length), settings);
        trace.moments.push_back (momentOf (followed, layout, static_cast<double> (first + length) / rate));
        trace.estimate = afterTime (std::move (followed.estimate), layout, settings.spread, window);

        if (progress)
            progress (static_cast<double> (first + step) / static_cast<double> (last + step));
    }

    return trace;
}
} // namespace antinode
