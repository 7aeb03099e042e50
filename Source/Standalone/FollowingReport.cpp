#include "FollowingReport.h"

#include <antinode_base/NumberText.h>
#include <antinode_session/FollowingWords.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace antinode
{
/** What is lost says another number with every window: only the first is news. */
std::string FollowingReport::news (const FollowingStatus& now)
{
    const auto isOtherState = std::exchange (state, now.state) != now.state;
    const auto isOtherReason = std::exchange (reason, now.reason) != now.reason;
    const auto hasJumped = state == FollowingState::following && ! reason.empty() && isOtherReason;

    if (! now.trace.empty())
        drift = now.trace.back().common;

    if (! isOtherState && ! hasJumped)
        return {};

    if (state == FollowingState::off)
        return "following off";

    return summary() + (reason.empty() ? std::string() : ": " + reason);
}

void FollowingReport::print (const FollowingStatus& now, double seconds)
{
    if (const auto what = news (now); ! what.empty())
    {
        std::printf ("%.2f s: %s\n", std::max (0.0, seconds), what.c_str());
        std::fflush (stdout);
    }
}

std::string FollowingReport::ending() const
{
    const auto drifted = summary();
    return drifted.empty() ? std::string() : "; " + drifted;
}

std::string FollowingReport::summary() const
{
    if (state == FollowingState::off)
        return {};

    return (drift ? formatted ("drift %+.2f %%, ", 100 * *drift) : std::string ("drift unknown, "))
           + std::string (wordFor (followingStateWords, state));
}
} // namespace antinode
