#include "Following.h"

#include <utility>

namespace antinode
{
void FollowingRequests::setSettings (const FollowingSettings& wanted)
{
    const std::lock_guard lock (mutex);
    asked.settings = wanted;
}

FollowingSettings FollowingRequests::settings() const
{
    const std::lock_guard lock (mutex);
    return asked.settings;
}

void FollowingRequests::setDrift (std::shared_ptr<const KnownDrift> known)
{
    const std::lock_guard lock (mutex);
    asked.drift = std::move (known);
    asked.isDriftNew = true;
}

std::shared_ptr<const KnownDrift> FollowingRequests::drift() const
{
    const std::lock_guard lock (mutex);
    return driftNow;
}

std::shared_ptr<const FollowingStatus> FollowingRequests::status() const
{
    const std::lock_guard lock (mutex);
    return statusNow;
}

FollowingRound FollowingRequests::take()
{
    const std::lock_guard lock (mutex);
    auto round = asked;
    asked.isDriftNew = false;
    asked.drift = nullptr;
    return round;
}

void FollowingRequests::publish (std::shared_ptr<const FollowingStatus> status, std::shared_ptr<const KnownDrift> drift)
{
    const std::lock_guard lock (mutex);
    statusNow = std::move (status);
    driftNow = std::move (drift);
}
} // namespace antinode
