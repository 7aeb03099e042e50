#include "StandaloneHost.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_focus/DriveAllocation.h>
#include <antinode_focus/TargetField.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace antinode
{
std::optional<TriggerLatency> triggerLatency (StandaloneHost& host)
{
    auto* const device = host.devices().getCurrentAudioDevice();
    const auto snapshot = host.processor().session().snapshot();

    if (device == nullptr || ! (device->getCurrentSampleRate() > 0) || snapshot == nullptr || snapshot->model == nullptr
        || snapshot->focus.targets.empty())
        return {};

    const auto rate = device->getCurrentSampleRate();
    return TriggerLatency { earliestFocusTime (snapshot->focus), device->getCurrentBufferSizeSamples() / rate,
                            std::max (0, device->getOutputLatencyInSamples()) / rate };
}

juce::String latencyInWords (const TriggerLatency& latency)
{
    const auto milliseconds = [] (double seconds) { return fixedText (seconds * 1000, 1); };
    return juce::String ("focus " + milliseconds (latency.whole())
                         + " ms after a note: " + milliseconds (latency.focusTime) + " focus time, "
                         + milliseconds (latency.block) + " block, " + milliseconds (latency.output) + " output");
}

juce::String latencyAdvice (const TriggerLatency& latency)
{
    const juce::String touch (" A touch is designed first, which takes the time of one design more: shortest with the "
                              "method exact and few modes.");

    if (latency.focusTime >= latency.block + latency.output)
        return "A shorter focus time lowers the latency most; it takes more voltage." + touch;

    return "A smaller block in Settings, Audio device, lowers the latency most; it takes more of the processor."
           + touch;
}

StandaloneHost::StandaloneHost (SettingsFile fileToUse, bool keepsSettings)
    : AudioHost (std::move (fileToUse), keepsSettings)
{
    if (kept.state)
        player.setState (*kept.state, true);

    begin (player);
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

/** The focus is without the touches that rest on the surface for a while. */
RemotePlayer StandaloneHost::remotePlayer()
{
    auto remote = remotePlayerOf (player);
    remote.voltageLimit = dynamic_cast<NumberParameter*> (player.parameters().find ("voltage_limit"));
    remote.load = [this] (const auto& device, const auto& focus) { player.load (device, focus); };
    remote.present = [this]
    {
        const auto now = player.session().snapshot();
        auto focus = now->focus;
        const auto touches = player.touches();
        std::erase_if (focus.fingers, [&] (const auto& finger)
                       { return std::find (touches.begin(), touches.end(), finger) != touches.end(); });
        return RemotePlayer::Present { now->device,       now->focusDocument, now->model,
                                       std::move (focus), now->isSolving,     now->error };
    };
    return remote;
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

void StandaloneHost::shutDown()
{
    touchInput.open ({ 0, 0, kept.touch.address });
    player.setTouches ({});
    AudioHost::shutDown();
}

Eigen::VectorXd StandaloneHost::limits()
{
    const auto now = player.session().snapshot();
    return now->model != nullptr ? voltageLimits (*now->model, now->focus.allocation) : Eigen::VectorXd();
}

juce::String StandaloneHost::touchLines (const TouchCounters& counters)
{
    const auto unplayed = touchInput.unplayed();
    const auto resting = static_cast<int> (player.touches().size());
    const auto waiting = std::max (0, static_cast<int> (touchInput.resting().count()) - resting);
    return juce::String (resting) + " fingers rest, " + juce::String (waiting) + " wait for room\n" + "Dropped: "
           + juce::String (counters.limited) + " foci above 500 per second, " + juce::String (faultCount (counters))
           + " faulty,\n" + juce::String (unplayed.outsideSurface) + " outside the surface, "
           + juce::String (unplayed.notAccepted) + " without a device or with a full queue,\n"
           + juce::String (unplayed.withoutKind) + " fingers while cursors play foci";
}

std::string StandaloneHost::unusedTouches (const TouchCounters& counters)
{
    const auto unplayed = touchInput.unplayed();
    const auto dropped = counters.limited + unplayed.notAccepted + unplayed.withoutKind + faultCount (counters);

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

    // Who arms again begins nothing of what was asked for before.
    if (const auto isArmed = arm().get(); std::exchange (wasArmed, isArmed) && ! isArmed)
        stopAll();

    if (const auto now = player.mutes(); std::exchange (seenMutes, now) != now)
        tellChange();
}
} // namespace antinode
