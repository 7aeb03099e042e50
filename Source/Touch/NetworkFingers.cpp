#include "NetworkFingers.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr double percent = 100;
constexpr auto retryInterval = std::chrono::seconds (1);

void set (IntegerParameter& parameter, int value)
{
    if (parameter.get() != value)
        parameter.setValueNotifyingHost (parameter.convertTo0to1 (static_cast<float> (value)));
}

bool isAbsent (const FingerParameters& finger)
{
    return finger.presence->get() == static_cast<int> (FingerPresence::absent);
}
} // namespace

NetworkFingers::NetworkFingers (TouchParameters& parametersToSet, std::function<int()> inputsOf,
                                std::function<void()> stopFoci)
    : parameters (parametersToSet), inputs (std::move (inputsOf)), stop (std::move (stopFoci))
{
}

NetworkFingers::~NetworkFingers()
{
    receiver.reset();
    cancelPendingUpdate();
}

void NetworkFingers::open (const TouchPorts& ports)
{
    const std::lock_guard lock (mutex);
    const auto areSame = ports.oscPort == wantedPorts.oscPort && ports.tuioPort == wantedPorts.tuioPort
                         && ports.address == wantedPorts.address;
    wantedPorts = ports;

    if (! areSame || (ports.oscPort == 0 && ports.tuioPort == 0))
    {
        receiver.reset();
        fingers.liftAll();
        triggerAsyncUpdate();
    }

    listen();
}

/** Under the lock. Who closes a port does not tell those who were refused it. */
void NetworkFingers::listen()
{
    isRefused = false;
    refusal.clear();
    lastTry = std::chrono::steady_clock::now();

    if (receiver != nullptr || (wantedPorts.oscPort == 0 && wantedPorts.tuioPort == 0))
        return;

    TouchOptions options;
    options.cursorsRest = true;

    try
    {
        receiver =
            std::make_unique<TouchReceiver> (wantedPorts, options, [this] (const Touch& touch) { take (touch); });
    }
    catch (const InputError& failure)
    {
        refusal = failure.what();
        isRefused = true;
        throw;
    }
}

bool NetworkFingers::retryWhenDue()
{
    if (! isRefused)
        return false;

    const std::lock_guard lock (mutex);

    if (std::chrono::steady_clock::now() - lastTry < retryInterval)
        return false;

    try
    {
        listen();
    }
    catch (const InputError&)
    {
        // It is in failure().
    }

    return ! isRefused;
}

std::string NetworkFingers::failure() const
{
    const std::lock_guard lock (mutex);
    return refusal;
}

TouchPorts NetworkFingers::wanted() const
{
    const std::lock_guard lock (mutex);
    return wantedPorts;
}

TouchPorts NetworkFingers::ports() const
{
    const std::lock_guard lock (mutex);
    return receiver != nullptr ? receiver->ports() : TouchPorts { 0, 0, wantedPorts.address };
}

TouchCounters NetworkFingers::counters() const
{
    const std::lock_guard lock (mutex);
    return receiver != nullptr ? receiver->counters() : TouchCounters {};
}

void NetworkFingers::take (const Touch& touch)
{
    if (touch.kind == TouchKind::stopAll)
        stop();

    fingers.take (touch);
    triggerAsyncUpdate();
}

void NetworkFingers::apply()
{
    std::array<bool, mostFingers> isFree {};

    for (std::size_t k = 0; k < isFree.size(); ++k)
        isFree[k] = static_cast<int> (k) < inputs() && isAbsent (parameters.finger (k));

    for (const auto& move : fingers.takeMoves (isFree))
        apply (move);
}

/** From the touch to the lift hosts see one gesture. */
void NetworkFingers::apply (const FingerMove& move)
{
    const auto& finger = parameters.finger (move.finger);
    const std::array places { finger.x, finger.y };

    if (move.kind == FingerMove::Kind::lift)
    {
        set (*finger.presence, static_cast<int> (FingerPresence::absent));

        for (auto* const place : places)
            place->endChangeGesture();

        return;
    }

    if (move.kind == FingerMove::Kind::down)
        for (auto* const place : places)
            place->beginChangeGesture();

    *finger.x = percent * move.x;
    *finger.y = percent * move.y;

    if (move.kind == FingerMove::Kind::move)
        return;

    const auto kind = std::find (fingerLoadWords.begin(), fingerLoadWords.end(), wanted().finger);

    if (kind != fingerLoadWords.begin() && kind != fingerLoadWords.end())
        set (*finger.load, static_cast<int> (kind - fingerLoadWords.begin()));

    const auto presence = static_cast<int> (move.finger) < inputs() ? FingerPresence::plays : FingerPresence::silent;
    set (*finger.presence, static_cast<int> (presence));
}
} // namespace antinode
