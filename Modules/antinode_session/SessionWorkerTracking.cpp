#include "SessionWorker.h"

#include <utility>

namespace antinode
{
namespace
{
constexpr double smallestDrift = 5e-5; // of a frequency: designs that are off by less stay
constexpr double largeDrift = 5e-4;    // designs that are off by more are not finished before

TrackingSettings neverFrozen (TrackingSettings settings)
{
    settings.isFrozen = false;
    return settings;
}
} // namespace

/** Another sensor needs a path that listens. */
void SessionWorker::takeTracking (const SessionRound& round)
{
    isSensorNew = isSensorNew || neverFrozen (tracking) != neverFrozen (round.tracking);
    tracking = round.tracking;

    if (tracker != nullptr)
        tracker->setFrozen (tracking.isFrozen);

    if (! round.isDriftNew)
        return;

    // An undo may bring one of another device.
    drift = round.drift != nullptr && model != nullptr && round.drift->isOf (*model) ? round.drift : nullptr;

    if (tracker != nullptr)
        tracker->setKnown (drift);
}

/** A ceramic that is not there is left to the tracker, which says so. */
std::vector<int> SessionWorker::idleCeramics() const
{
    const auto isThere = model != nullptr && tracking.ceramic >= 0 && tracking.ceramic < model->actuators();
    return tracking.isCeramic() && isThere ? std::vector { tracking.ceramic + 1 } : std::vector<int>();
}

/** What a new path tells, and who listens to it. */
Listening SessionWorker::listen()
{
    tracker.reset();

    if (! tracking.isOn())
    {
        drift.reset();
        return {};
    }

    Listening listening { std::make_shared<SensorTap> (played->actuators(), rate) };

    for (const auto ceramic : idle)
        listening.idle |= 1ULL << (ceramic - 1);

    // Under fingers the modes are others: the tracker says what it cannot follow.
    tracker = std::make_unique<DriftTracker> (DriftTracker::Setup {
        fingers.empty() ? model : played, tracking, listening.tap, drift, requests->trackingStatus()->trace });
    return listening;
}

void SessionWorker::readTracker()
{
    const auto status = tracker != nullptr ? tracker->status() : notTracked;
    const auto modes = model != nullptr ? model->modes() : 0;

    if (tracker != nullptr)
        drift = tracker->known();

    if (drift == seenDrift && status == seenStatus && driftChanges.size() == modes)
        return;

    driftChanges = drift != nullptr ? frequencyChanges (drift->tracked.estimate, drift->layout, modes)
                                    : Eigen::VectorXd::Zero (modes).eval();
    seenStatus = status;
    seenDrift = drift;
    auto now = *status;
    now.redesigns = redesigns;
    requests->publishTracking (std::make_shared<const TrackingStatus> (std::move (now)), drift);
}

/** While the bank is designed, only a large drift makes it begin again. */
bool SessionWorker::hasDrifted() const
{
    if (path == nullptr || ! fingers.empty() || designedChanges.size() != driftChanges.size())
        return false;

    const auto largest = (driftChanges - designedChanges).cwiseAbs().maxCoeff();
    return largest > largeDrift || (largest > smallestDrift && path->worker().progress().isDone());
}

/** A model with the drift that is known. */
std::shared_ptr<const ModalModel> SessionWorker::asItIs (const std::shared_ptr<const ModalModel>& known) const
{
    if (drift == nullptr || ! fingers.empty())
        return known;

    return std::make_shared<const ModalModel> (retunedModel (*known, drift->tracked.estimate, drift->layout));
}
} // namespace antinode
