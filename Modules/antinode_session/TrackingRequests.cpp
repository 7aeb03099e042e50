#include "TrackingRequests.h"

#include <utility>

namespace antinode
{
void TrackingRequests::setSettings (const TrackingSettings& wanted)
{
    const std::lock_guard lock (mutex);
    asked.settings = wanted;
}

TrackingSettings TrackingRequests::settings() const
{
    const std::lock_guard lock (mutex);
    return asked.settings;
}

void TrackingRequests::setDrift (std::shared_ptr<const KnownDrift> known)
{
    const std::lock_guard lock (mutex);
    asked.drift = std::move (known);
    asked.isDriftNew = true;
}

std::shared_ptr<const KnownDrift> TrackingRequests::drift() const
{
    const std::lock_guard lock (mutex);
    return driftNow;
}

std::shared_ptr<const TrackingStatus> TrackingRequests::status() const
{
    const std::lock_guard lock (mutex);
    return statusNow;
}

TrackingRound TrackingRequests::take()
{
    const std::lock_guard lock (mutex);
    auto round = asked;
    asked.isDriftNew = false;
    asked.drift = nullptr;
    return round;
}

void TrackingRequests::publish (std::shared_ptr<const TrackingStatus> status, std::shared_ptr<const KnownDrift> drift)
{
    const std::lock_guard lock (mutex);
    statusNow = std::move (status);
    driftNow = std::move (drift);
}
} // namespace antinode
