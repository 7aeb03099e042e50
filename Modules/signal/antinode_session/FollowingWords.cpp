#include "FollowingWords.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

namespace antinode
{
namespace
{
std::string driftOf (const FollowingStatus& status)
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

std::string followingSentence (const FollowingStatus& status)
{
    switch (status.state)
    {
        case FollowingState::off:
            return "No sensor is chosen.";
        case FollowingState::waiting:
            return "Waiting: play something that the sensor hears.";
        case FollowingState::silent:
            return "Silent: too little is played; last " + driftOf (status) + ".";
        case FollowingState::lost:
            return withReason ("Lost:", status.reason);
        case FollowingState::frozen:
            return "Frozen: " + driftOf (status) + ".";
        case FollowingState::paused:
            return withReason ("Paused: " + driftOf (status) + ".", status.reason);
        case FollowingState::impossible:
            return withReason ("Not possible:", status.reason);
        case FollowingState::following:
            break;
    }

    return withReason ("Following: " + driftOf (status)
                           + formatted (", %.2f ms after the voltages.", milli * status.delay),
                       status.reason);
}

UserMessage followingMessage (const FollowingStatus& status)
{
    const auto fails = status.state == FollowingState::lost || status.state == FollowingState::impossible;
    return fails ? UserMessage { Urgency::caution, "Following of the drift: " + followingSentence (status) }
                 : UserMessage {};
}
} // namespace antinode
