#include "StandaloneHost.h"

#include "TouchWords.h"
#include "TriggerLatency.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/DriveAllocation.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace antinode
{
StandaloneHost::StandaloneHost (SettingsFile fileToUse, bool keepsSettings)
    : AudioHost (std::move (fileToUse), keepsSettings)
{
    if (kept.state)
        player.setState (*kept.state, true);

    begin (player, midiQueue);
    callback().setInputs (sensorAlone());
}

StandaloneHost::~StandaloneHost()
{
    end();
}

void StandaloneHost::setTouch (const TouchPorts& ports)
{
    kept.touch = ports;
    tellChange();
    touchInput.open (ports);
}

void StandaloneHost::restTouches()
{
    const auto now = model();

    if (now == nullptr)
        return;

    const auto own = player.state().focus;
    const auto wanted = touchInput.resting().due (own->description.fingers, player.touches(), now->surface,
                                                  std::chrono::steady_clock::now());

    if (wanted && ! attempt (MessageSource::fingers, [&] { player.setTouches (*wanted); }))
        tellChange();
}

void StandaloneHost::setMidi (const MidiChoice& choice)
{
    kept.midi = choice;
    midiInputs.choose (choice);
    tellChange();
}

void StandaloneHost::openAll (const StandaloneSettings& wanted)
{
    setMidi (wanted.midi);
    AudioHost::openAll (wanted);
}

void StandaloneHost::shutDown()
{
    touchInput.open ({ 0, 0, kept.touch.address });
    player.setTouches ({});
    AudioHost::shutDown();
}

std::vector<UserMessage> StandaloneHost::playerMessages()
{
    auto messages = player.messages();

    for (auto& message : midiInputs.messages())
        messages.push_back (std::move (message));

    return messages;
}

Eigen::VectorXd StandaloneHost::limits()
{
    const auto now = player.session().snapshot();
    return now->model != nullptr ? voltageLimits (*now->model, now->focus.allocation) : Eigen::VectorXd();
}

juce::String StandaloneHost::touchStatus()
{
    const auto counters = touchInput.counters();
    const auto unplayed = touchInput.unplayed();
    const auto resting = static_cast<int> (player.touches().size());
    const auto waiting = std::max (0, static_cast<int> (touchInput.resting().count()) - resting);
    return portsInWords (touchInput.ports()) + "\n" + packetsInWords (counters) + "\n" + juce::String (resting)
           + " fingers rest, " + juce::String (waiting) + " wait for room\n" + "Dropped: "
           + juce::String (counters.limited) + " foci above 500 per second, " + juce::String (faultCount (counters))
           + " faulty,\n" + juce::String (unplayed.outsideSurface) + " outside the surface, "
           + juce::String (unplayed.notAccepted) + " without a device or with a full queue,\n"
           + juce::String (unplayed.withoutKind) + " fingers while cursors play foci";
}

std::string StandaloneHost::touchOutcome()
{
    const auto counters = touchInput.counters();
    const auto unplayed = touchInput.unplayed();
    const auto dropped = counters.limited + unplayed.notAccepted + unplayed.withoutKind + faultCount (counters);

    if (counters.packets == 0)
        return {};

    return std::to_string (unplayed.outsideSurface) + " outside the surface, " + std::to_string (dropped)
           + " dropped for other reasons";
}

juce::String StandaloneHost::latencyText()
{
    const auto latency = triggerLatency (*this);
    return latency ? latencyInWords (*latency) : juce::String();
}

juce::String StandaloneHost::latencyAdviceText()
{
    const auto latency = triggerLatency (*this);
    return latency ? latencyAdvice (*latency) : juce::String();
}

void StandaloneHost::tick()
{
    restTouches();

    if (const auto now = player.mutes(); std::exchange (seenMutes, now) != now)
        tellChange();
}
} // namespace antinode
