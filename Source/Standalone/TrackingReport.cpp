#include "TrackingReport.h"

#include <antinode_base/NumberText.h>
#include <antinode_session/TrackingWords.h>

#include <algorithm>
#include <cstdio>
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

void TrackingReport::print (const TrackingStatus& now, double seconds)
{
    if (const auto what = news (now); ! what.empty())
    {
        std::printf ("%.2f s: %s\n", std::max (0.0, seconds), what.c_str());
        std::fflush (stdout);
    }
}

std::string TrackingReport::ending() const
{
    const auto drifted = summary();
    return drifted.empty() ? std::string() : "; " + drifted;
}

std::string TrackingReport::summary() const
{
    if (state == TrackingState::off)
        return {};

    return (drift ? formatted ("drift %+.2f %%, ", 100 * *drift) : std::string ("drift unknown, "))
           + std::string (wordFor (trackingStateWords, state));
}
} // namespace antinode
