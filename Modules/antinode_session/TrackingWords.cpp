#include "TrackingWords.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

namespace antinode
{
namespace
{
std::string driftOf (const TrackingStatus& status)
{
    if (status.trace.empty())
        return "nothing was heard yet";

    const auto& newest = status.trace.back();
    return formatted ("%+.2f %% (+-%.0f ppm)", 100 * newest.common, micro * newest.deviation);
}

std::string withReason (const std::string& sentence, const std::string& reason)
{
    return reason.empty() ? sentence : sentence + " " + reason;
}
} // namespace

std::string trackingSentence (const TrackingStatus& status)
{
    switch (status.state)
    {
        case TrackingState::off:
            return "No sensor is chosen.";
        case TrackingState::waiting:
            return "Waiting: play something that the sensor hears.";
        case TrackingState::silent:
            return "Silent: too little is played; last " + driftOf (status) + ".";
        case TrackingState::lost:
            return withReason ("Lost:", status.reason);
        case TrackingState::frozen:
            return "Frozen: " + driftOf (status) + ".";
        case TrackingState::paused:
            return withReason ("Paused: " + driftOf (status) + ".", status.reason);
        case TrackingState::impossible:
            return withReason ("Not possible:", status.reason);
        case TrackingState::following:
            break;
    }

    return withReason ("Following: " + driftOf (status)
                           + formatted (", %.2f ms after the voltages.", milli * status.delay),
                       status.reason);
}

UserMessage trackingMessage (const TrackingStatus& status)
{
    const auto fails = status.state == TrackingState::lost || status.state == TrackingState::impossible;
    return fails ? UserMessage { Urgency::caution, "Tracking of the drift: " + trackingSentence (status) }
                 : UserMessage {};
}
} // namespace antinode
