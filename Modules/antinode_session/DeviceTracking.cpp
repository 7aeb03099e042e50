#include "DeviceTracking.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
TrackingSettings neverFrozen (TrackingSettings settings)
{
    settings.isFrozen = false;
    return settings;
}

/** Modes that are not tracked follow the others but for what each has of its own. */
FrequencyShift shiftBy (const std::shared_ptr<const KnownDrift>& drift, Eigen::Index modes)
{
    FrequencyShift shift { Eigen::VectorXd::Zero (modes), Eigen::VectorXd::Zero (modes) };

    if (drift == nullptr)
        return shift;

    const auto& [nominal, layout, tracked] = *drift;
    shift.changes = frequencyChanges (tracked.estimate, layout, modes);
    shift.deviations.setConstant (DriftSpread().frequency);

    for (Eigen::Index k = 0; k < std::min (modes, layout.modes); ++k)
        shift.deviations[k] = tracked.estimate.deviation (layout.frequency (k));

    return shift;
}
} // namespace

DeviceTracking::DeviceTracking (std::shared_ptr<TrackingRequests> requestsToServe)
    : requests (std::move (requestsToServe))
{
}

void DeviceTracking::take (const ModalModel* model)
{
    const auto round = requests->take();
    hasOtherSensor = hasOtherSensor || neverFrozen (settings) != neverFrozen (round.settings);
    settings = round.settings;

    if (tracker != nullptr)
        tracker->setFrozen (settings.isFrozen);

    if (! round.isDriftNew)
        return;

    // An undo may bring one of another device.
    drift = round.drift != nullptr && model != nullptr && round.drift->isOf (*model) ? round.drift : nullptr;

    if (tracker != nullptr)
        tracker->setKnown (drift);
}

void DeviceTracking::forget()
{
    tracker.reset();
    drift.reset();
}

std::vector<int> DeviceTracking::idleCeramics (const ModalModel* model) const
{
    const auto isThere = model != nullptr && settings.ceramic >= 0 && settings.ceramic < model->actuators();
    return settings.isCeramic() && isThere ? std::vector { settings.ceramic + 1 } : std::vector<int>();
}

Listening DeviceTracking::listen (std::shared_ptr<const ModalModel> tracked, double sampleRate)
{
    tracker.reset();
    hasOtherSensor = false;

    if (! settings.isOn())
    {
        drift.reset();
        return {};
    }

    Listening listening { std::make_shared<SensorTap> (tracked->actuators(), sampleRate) };

    for (const auto ceramic : idleCeramics (tracked.get()))
        listening.idle |= 1ULL << (ceramic - 1);

    tracker = std::make_unique<DriftTracker> (
        DriftTracker::Setup { std::move (tracked), settings, listening.tap, drift, requests->status()->trace });
    tracker->setHindrance (hindrance);
    return listening;
}

void DeviceTracking::setHindrance (const std::string& reason)
{
    if (std::exchange (hindrance, reason) != reason && tracker != nullptr)
        tracker->setHindrance (reason);
}

void DeviceTracking::read (const ModalModel* model)
{
    const auto status = tracker != nullptr ? tracker->status() : notTracked;
    const auto modes = model != nullptr ? model->modes() : 0;

    if (tracker != nullptr)
        drift = tracker->known();

    if (drift == seenDrift && status == seenStatus && shifted.changes.size() == modes)
        return;

    shifted = shiftBy (drift, modes);
    seenStatus = status;
    seenDrift = drift;
    auto now = *status;
    now.redesigns = redesigns;
    requests->publish (std::make_shared<const TrackingStatus> (std::move (now)), drift);
}

void DeviceTracking::noteDesigned()
{
    redesigns += designed.note (shifted.changes) ? 1 : 0;
}
} // namespace antinode
