#include "TrackingReport.h"

#include <antinode_base/NumberText.h>
#include <antinode_session/TrackingWords.h>

#include <utility>

namespace antinode
{
/** What is lost says another number with every window: only the first is news. */
std::string TrackingReport::news (const TrackingStatus& now)
{
    const auto isOtherState = std::exchange (state, now.state) != now.state;
    const auto isOtherReason = std::exchange (reason, now.reason) != now.reason;
    const auto hasJumped = state == TrackingState::following && ! reason.empty() && isOtherReason;

    if (! now.trace.empty())
        drift = now.trace.back().common;

    if (! isOtherState && ! hasJumped)
        return {};

    if (state == TrackingState::off)
        return "tracking off";

    return summary() + (reason.empty() ? std::string() : ": " + reason);
}

std::string TrackingReport::summary() const
{
    if (state == TrackingState::off)
        return {};

    return (drift ? formatted ("drift %+.2f %%, ", 100 * *drift) : std::string ("drift unknown, "))
           + std::string (wordFor (trackingStateWords, state));
}
} // namespace antinode
