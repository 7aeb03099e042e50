#include "DriftFollower.h"

#include "SensorTap.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_learning/FollowDrift.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto tapInterval = std::chrono::milliseconds (50); // between looks at the tap
constexpr std::size_t longestTrace = 4000;                   // moments

DriftSensor sensorOf (const FollowingSettings& settings, const ModalModel& model)
{
    const auto isAmount =
        settings.sensor == FollowingSensor::displacement || settings.sensor == FollowingSensor::ceramicCharge;
    const auto quantity = isAmount ? SensorQuantity::amount : SensorQuantity::rate;

    if (settings.isCeramic())
    {
        if (settings.ceramic < 0 || settings.ceramic >= model.actuators())
            throw InputError ("following", "ceramic " + std::to_string (settings.ceramic + 1)
                                               + " is not on the device; allowed: 1 to "
                                               + std::to_string (model.actuators()));

        // By reciprocity.
        return { model.participation.col (settings.ceramic).transpose(), quantity, true };
    }

    return { shapesAt (model, settings.xMillimetres / milli, settings.yMillimetres / milli), quantity, false };
}

FollowingState stateOf (DriftState state, const SensedDrift& drift)
{
    if (state == DriftState::following)
        return FollowingState::following;

    if (state == DriftState::lost)
        return FollowingState::lost;

    return drift.scale == 0 ? FollowingState::waiting : FollowingState::silent;
}
} // namespace

/** What owner and thread share; the thread may go on after the owner. */
struct DriftFollower::Work
{
    explicit Work (Setup given)
        : setup (std::move (given)), isFrozen (setup.settings.isFrozen), isDriftNew (setup.known != nullptr),
          drift (setup.known)
    {
    }

    /** What the owner wants, to be taken by the thread. */
    struct Wish
    {
        bool isStopping = false, isFrozen = false, isDriftNew = false;
        std::shared_ptr<const KnownDrift> drift;
        std::string hindrance;
    };

    Wish awaitWish();
    void publish (const FollowingStatus&, std::shared_ptr<const KnownDrift>);

    const Setup setup;
    mutable std::mutex mutex; ///< For all that follows.
    std::condition_variable wake;
    bool isStopping = false, isFrozen, isDriftNew;
    std::shared_ptr<const KnownDrift> drift;
    std::string hindrance;
    std::shared_ptr<const FollowingStatus> status = std::make_shared<const FollowingStatus>();
};

DriftFollower::Work::Wish DriftFollower::Work::awaitWish()
{
    std::unique_lock lock (mutex);
    wake.wait_for (lock, tapInterval, [this] { return isStopping || isDriftNew; });
    return { isStopping, isFrozen, std::exchange (isDriftNew, false), drift, hindrance };
}

/** Not over what the owner wants meanwhile. */
void DriftFollower::Work::publish (const FollowingStatus& now, std::shared_ptr<const KnownDrift> known)
{
    auto made = std::make_shared<const FollowingStatus> (now);
    const std::lock_guard lock (mutex);
    status = std::move (made);

    if (! isDriftNew && known != nullptr)
        drift = std::move (known);
}

/** The work of the thread. */
class DriftFollower::Follower
{
public:
    explicit Follower (Work& shared)
        : work (shared), rate (shared.setup.tap->sampleRate()), nominal (followedModes (*shared.setup.model, rate)),
          sensor (sensorOf (shared.setup.settings, nominal)), layout (driftLayout (nominal, 1)),
          settings (settingsFor (nominal)), recent (*shared.setup.tap, followedLength (settings)),
          sensed (startOfFollowing (layout, settings.spread)),
          step (static_cast<Eigen::Index> (std::ceil (followedWindow * rate)))
    {
        present.trace = shared.setup.trace;
        time = present.trace.empty() ? 0 : present.trace.back().time;
    }

    void run()
    {
        for (auto wish = work.awaitWish(); ! wish.isStopping; wish = work.awaitWish())
        {
            passed += recent.take (*work.setup.tap);

            if (wish.isDriftNew)
                goOnFrom (wish.drift);

            if (wish.isFrozen)
                say (FollowingState::frozen, {});
            else if (! wish.hindrance.empty())
                pause (wish.hindrance);
            else if (recent.isFull() && passed >= step)
                followRecent();
            else if (present.state == FollowingState::off || present.state == FollowingState::frozen
                     || present.state == FollowingState::paused)
                say (FollowingState::waiting, {});
        }
    }

private:
    static DriftSettings settingsFor (const ModalModel& model)
    {
        DriftSettings chosen;
        chosen.memory = followingMemory (model);
        return chosen;
    }

    /** Another layout is another device. */
    void goOnFrom (const std::shared_ptr<const KnownDrift>& known)
    {
        const auto fits = known != nullptr && known->layout.size() == layout.size() && known->isOf (nominal);
        sensed = fits ? known->sensed : startOfFollowing (layout, settings.spread);
        sensed.scale = 0; // An audio device that was opened again has another delay.
        recent.forget();
    }

    void say (FollowingState state, std::string reason)
    {
        if (state == present.state && reason == present.reason)
            return;

        present.state = state;
        present.reason = std::move (reason);
        work.publish (present, nullptr);
    }

    /** What was heard meanwhile is of another surface. */
    void pause (const std::string& reason)
    {
        recent.forget();
        say (FollowingState::paused, reason);
    }

    void followRecent()
    {
        const auto elapsed = static_cast<double> (std::exchange (passed, 0)) / rate;
        const auto begin = std::chrono::steady_clock::now();
        const auto wasFound = sensed.scale != 0; // Else it is no jump, but where the device was all the time.
        auto before = sensed;
        before.estimate = afterTime (std::move (before.estimate), layout, settings.spread, elapsed);
        auto window =
            followWindow (nominal, sensor, before, { rate, recent.voltages(), recent.sensor(), {}, 0 }, settings);
        sensed = std::move (window.drift);
        time += elapsed;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        present.longestWindow = std::max (present.longestWindow, took.count());
        note (window.followed, wasFound);
        work.publish (present,
                      std::make_shared<const KnownDrift> (KnownDrift { nominal.angularFrequencies, layout, sensed }));
    }

    void note (const FollowedDrift& followed, bool wasFound)
    {
        const auto moment = momentOf (followed, layout, time);
        present.state = stateOf (followed.state, sensed);
        present.reason = followed.reason;

        if (followed.jump != 0 && wasFound)
            present.reason =
                "All frequencies have jumped by " + inWords (100 * followed.jump) + " % at " + inWords (time) + " s.";

        present.changes = moment.frequencies;
        present.deviations = moment.deviations;
        present.delay = sensed.delay;
        const auto weights = moment.deviations.array().max (1e-12).square().inverse();
        present.trace.push_back (
            { time, present.state, moment.common, std::sqrt (1 / weights.sum()), moment.unexplained });

        if (present.trace.size() > longestTrace)
            present.trace.erase (present.trace.begin());
    }

    Work& work;
    double rate;
    ModalModel nominal;
    DriftSensor sensor;
    DriftLayout layout;
    DriftSettings settings;
    RecentFrames recent;
    SensedDrift sensed;
    FollowingStatus present;
    Eigen::Index step, passed = 0; // frames of a window, and since the last one
    double time = 0;               // s
};

/** Until the owner leaves; what cannot be followed is said. */
void DriftFollower::follow (Work& work)
{
    const auto mayGoOn = [&work]
    {
        const std::lock_guard lock (work.mutex);
        return ! work.isStopping;
    };

    try
    {
        const WatchScope scope (mayGoOn);
        Follower (work).run();
    }
    catch (const Cancelled&)
    {
        // The owner has left.
    }
    catch (const std::exception& failure)
    {
        FollowingStatus status;
        status.state = FollowingState::impossible;
        status.reason = failure.what();
        work.publish (status, nullptr);
    }
}

DriftFollower::DriftFollower (Setup setup)
    : work (std::make_shared<Work> (std::move (setup))), thread ([kept = work] { follow (*kept); })
{
}

DriftFollower::~DriftFollower()
{
    const std::lock_guard lock (work->mutex);
    work->isStopping = true;
    work->wake.notify_all();
}

void DriftFollower::setFrozen (bool shouldBeFrozen)
{
    const std::lock_guard lock (work->mutex);
    work->isFrozen = shouldBeFrozen;
}

void DriftFollower::setHindrance (const std::string& reason)
{
    const std::lock_guard lock (work->mutex);
    work->hindrance = reason;
}

void DriftFollower::setKnown (std::shared_ptr<const KnownDrift> known)
{
    const std::lock_guard lock (work->mutex);
    work->drift = std::move (known);
    work->isDriftNew = true;
    work->wake.notify_all();
}

std::shared_ptr<const KnownDrift> DriftFollower::known() const
{
    const std::lock_guard lock (work->mutex);
    return work->drift;
}

std::shared_ptr<const FollowingStatus> DriftFollower::status() const
{
    const std::lock_guard lock (work->mutex);
    return work->status;
}

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
