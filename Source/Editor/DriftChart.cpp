#include "DriftChart.h"

#include <antinode_base/Prefixes.h>

#include <limits>

namespace antinode
{
namespace
{
constexpr double percent = 100, secondsInMinute = 60, fewMinutes = 3;
} // namespace

LineChart driftChart (const FollowingStatus& status)
{
    const auto count = static_cast<Eigen::Index> (status.trace.size());
    const auto latest = count > 0 ? status.trace.back().time : 0;
    const auto isLong = latest > fewMinutes * secondsInMinute;
    Eigen::VectorXd times (count), drifts (count), deviations (count);

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& moment = status.trace[static_cast<std::size_t> (i)];
        const auto isKnown = moment.state == FollowingState::following;
        times[i] = moment.time / (isLong ? secondsInMinute : 1);
        drifts[i] = isKnown ? percent * moment.common : std::numeric_limits<double>::quiet_NaN();
        deviations[i] = percent * moment.deviation;
    }

    LineChart chart;
    chart.title = "Drift that all frequencies share";
    chart.xLabel = isLong ? "time of playing (min)" : "time of playing (s)";
    chart.yLabel = "drift (%)";
    chart.series = { { "drift", times, drifts, LineStyle::solid, false, true },
                     { "two deviations", times, drifts + 2 * deviations, LineStyle::dotted },
                     { "", times, drifts - 2 * deviations, LineStyle::dotted, false, false, 1 } };
    return chart;
}
} // namespace antinode
