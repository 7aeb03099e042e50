#include "NetworkFingers.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr double percent = 100;
constexpr std::array loadNames { "", "light", "medium", "firm" }; // of FingerLoad

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
    receiver.reset();
    fingers.liftAll();
    triggerAsyncUpdate();
    wantedPorts = ports;

    if (ports.oscPort == 0 && ports.tuioPort == 0)
        return;

    TouchOptions options;
    options.cursorsRest = true;
    receiver = std::make_unique<TouchReceiver> (ports, options, [this] (const Touch& touch) { take (touch); });
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

    const auto kind = std::find (loadNames.begin(), loadNames.end(), wanted().finger);

    if (kind != loadNames.begin() && kind != loadNames.end())
        set (*finger.load, static_cast<int> (kind - loadNames.begin()));

    const auto presence = static_cast<int> (move.finger) < inputs() ? FingerPresence::plays : FingerPresence::silent;
    set (*finger.presence, static_cast<int> (presence));
}
} // namespace antinode
