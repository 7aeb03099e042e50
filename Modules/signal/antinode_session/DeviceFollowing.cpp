#include "DeviceFollowing.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
FollowingSettings neverFrozen (FollowingSettings settings)
{
    settings.isFrozen = false;
    return settings;
}

/** Modes that are not followed follow the others but for what each has of its own. */
FrequencyShift shiftBy (const std::shared_ptr<const KnownDrift>& drift, Eigen::Index modes)
{
    FrequencyShift shift { Eigen::VectorXd::Zero (modes), Eigen::VectorXd::Zero (modes) };

    if (drift == nullptr)
        return shift;

    const auto& [nominal, layout, sensed] = *drift;
    shift.changes = frequencyChanges (sensed.estimate, layout, modes);
    shift.deviations.setConstant (DriftSpread().frequency);

    for (Eigen::Index k = 0; k < std::min (modes, layout.modes); ++k)
        shift.deviations[k] = sensed.estimate.deviation (layout.frequency (k));

    return shift;
}
} // namespace

DeviceFollowing::DeviceFollowing (std::shared_ptr<FollowingRequests> requestsToServe)
    : requests (std::move (requestsToServe))
{
}

void DeviceFollowing::take (const ModalModel* model)
{
    const auto round = requests->take();
    hasOtherSensor = hasOtherSensor || neverFrozen (settings) != neverFrozen (round.settings);
    settings = round.settings;

    if (follower != nullptr)
        follower->setFrozen (settings.isFrozen);

    if (! round.isDriftNew)
        return;

    // An undo may bring one of another device.
    drift = round.drift != nullptr && model != nullptr && round.drift->isOf (*model) ? round.drift : nullptr;

    if (follower != nullptr)
        follower->setKnown (drift);
}

void DeviceFollowing::forget()
{
    follower.reset();
    drift.reset();
}

std::vector<int> DeviceFollowing::idleCeramics (const ModalModel* model) const
{
    const auto isThere = model != nullptr && settings.ceramic >= 0 && settings.ceramic < model->actuators();
    return settings.isCeramic() && isThere ? std::vector { settings.ceramic + 1 } : std::vector<int>();
}

Listening DeviceFollowing::listen (std::shared_ptr<const ModalModel> followed, double sampleRate)
{
    follower.reset();
    hasOtherSensor = false;

    if (! settings.isOn())
    {
        drift.reset();
        return {};
    }

    Listening listening { std::make_shared<SensorTap> (followed->actuators(), sampleRate) };

    for (const auto ceramic : idleCeramics (followed.get()))
        listening.idle |= 1ULL << (ceramic - 1);

    follower = std::make_unique<DriftFollower> (
        DriftFollower::Setup { std::move (followed), settings, listening.tap, drift, requests->status()->trace });
    follower->setHindrance (hindrance);
    return listening;
}

void DeviceFollowing::setHindrance (const std::string& reason)
{
    if (std::exchange (hindrance, reason) != reason && follower != nullptr)
        follower->setHindrance (reason);
}

void DeviceFollowing::read (const ModalModel* model)
{
    const auto status = follower != nullptr ? follower->status() : notFollowed;
    const auto modes = model != nullptr ? model->modes() : 0;

    if (follower != nullptr)
        drift = follower->known();

    if (drift == seenDrift && status == seenStatus && shifted.changes.size() == modes)
        return;

    shifted = shiftBy (drift, modes);
    seenStatus = status;
    seenDrift = drift;
    auto now = *status;
    now.redesigns = redesigns;
    requests->publish (std::make_shared<const FollowingStatus> (std::move (now)), drift);
}

void DeviceFollowing::noteDesigned()
{
    redesigns += designed.note (shifted.changes) ? 1 : 0;
}
} // namespace antinode
