#include "TouchProcessor.h"

#include <antinode_base/InputError.h>
#include <antinode_session/FollowingWords.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto oscKey = TouchProcessor::portKeys[0], tuioKey = TouchProcessor::portKeys[1],
               networkKey = TouchProcessor::portKeys[2];
constexpr auto thisComputer = "127.0.0.1", wholeNetwork = "0.0.0.0";

double valueOf (const std::map<std::string, double>& values, const char* key)
{
    const auto found = values.find (key);
    return found != values.end() ? found->second : 0;
}

/** What is no port is one that cannot be opened, not another one. */
int portFrom (double value)
{
    constexpr double beyond = 65536;
    return value == std::floor (value) ? static_cast<int> (std::clamp (value, 0.0, beyond)) : static_cast<int> (beyond);
}
} // namespace

std::function<juce::AudioProcessorEditor*(TouchProcessor&)> TouchProcessor::makeEditor;

/** It starts with a plate that is solved quickly: fingers rest on plates. */
TouchProcessor::TouchProcessor (int ceramics, WrapperType wrapper)
    : DeviceEffect ({ "Fingers", maximumFingers, maximumFingers }, { "Ceramics", ceramics, maximumCeramics },
                    SensorBus::one, wrapper, touchSchema, "aluminium-200x120")
{
    controls = std::make_unique<TouchParameters> (*this, [this]
                                                  { return player != nullptr ? player->snapshot()->model : nullptr; });

    if (wrapper == wrapperType_VST3)
        controls->stepReports().add (addStop());

    touches = std::make_unique<NetworkFingers> (
        *controls, [this] { return inputs(); }, [this] { player->stopAll(); });
    player = std::make_unique<TouchSession> (
        *device(), [this] { return readSettings(); }, [this] { post(); });
    begin();
}

TouchProcessor::~TouchProcessor()
{
    touches->open ({ 0, 0, "127.0.0.1" }); // No touch stops a player that is gone.
    end();
    player.reset(); // It looks at touches.
    touches.reset();
}

void TouchProcessor::take (std::shared_ptr<const DeviceDocument> device)
{
    if (device->description.requiresArming)
        controls->arm().setValueNotifyingHost (0);

    player->load (std::move (device));
}

void TouchProcessor::loadFocus (const std::shared_ptr<const FocusDocument>& focus)
{
    takeFocus (focus);
    post();
}

void TouchProcessor::takeFocus (const std::shared_ptr<const FocusDocument>& wanted)
{
    const auto now = focus();

    if ((now == nullptr) != (wanted == nullptr) || (now != nullptr && ! sayTheSame (*now, *wanted)))
        player->loadFocus (wanted);
}

void TouchProcessor::takeNotes (const juce::MidiBuffer& midi, int count)
{
    notes = triggers.read (midi, count);
}

void TouchProcessor::setValues (const std::map<std::string, double>& wanted, const DeviceDocument& device)
{
    auto values = wanted;

    if (device.description.requiresArming)
        values["arm"] = 0;

    // Fingers that touch stay where they are.
    const auto now = controls->values();

    for (const auto& key : touchedKeys ({ "x", "y", "state", "load" }))
        values[key] = now.at (key);

    controls->setValues (values);
    openPorts (wanted);
}

/** The identifiers of these parameters of all fingers that touches are. */
std::vector<std::string> TouchProcessor::touchedKeys (std::initializer_list<const char*> names) const
{
    std::vector<std::string> keys;
    const auto touched = touches->touches().touched();

    for (std::size_t k = 0; k < touched.size(); ++k)
        if (touched[k])
            for (const auto* const name : names)
                keys.push_back ("finger" + std::to_string (k + 1) + "_" + name);

    return keys;
}

/** Without touches: nobody would lift them where the state comes back. */
std::map<std::string, double> TouchProcessor::values() const
{
    auto values = controls->values();
    const auto ports = touches->wanted();

    for (const auto& key : touchedKeys ({ "state" }))
        values[key] = static_cast<double> (FingerPresence::absent);

    if (ports.oscPort != 0 || ports.tuioPort != 0)
        values.insert ({ { oscKey, ports.oscPort },
                         { tuioKey, ports.tuioPort },
                         { networkKey, ports.address == thisComputer ? 0 : 1 } });

    return values;
}

/** Those of a state. */
void TouchProcessor::openPorts (const std::map<std::string, double>& values)
{
    const auto now = touches->wanted();
    const TouchPorts ports { portFrom (valueOf (values, oscKey)), portFrom (valueOf (values, tuioKey)),
                             valueOf (values, networkKey) > 0 ? wholeNetwork : thisComputer, now.finger };

    // Touches that came by no port stay.
    if (ports.oscPort == 0 && ports.tuioPort == 0 && now.oscPort == 0 && now.tuioPort == 0)
        return;

    try
    {
        touches->open (ports);
    }
    catch (const InputError&)
    {
        // It is in our warning.
    }
}

std::vector<UserMessage> TouchProcessor::ownMessages()
{
    const auto now = player->snapshot();
    const auto channels = getChannelCountOfBus (false, 0);
    const auto ceramics = now->model != nullptr ? static_cast<int> (now->model->actuators()) : 0;
    std::vector<UserMessage> messages;
    addMessage (messages, Urgency::warning, touches->failure());
    addMessage (messages, Urgency::warning, now->error);
    addMessage (messages, Urgency::warning, now->formatError);

    if (! now->designError.empty())
        addMessage (messages, Urgency::warning, now->designError + "; the filters before play on");

    if (const auto error = player->focusProgress().liveError; ! error.empty())
        addMessage (messages, Urgency::warning, "Notes play nothing: " + error);

    if (player->meters().isMutedForBadNumbers())
        addMessage (messages, Urgency::warning,
                    "A voltage was not a finite number: all voltages are 0 V until playback starts again.");

    if (ceramics > channels)
        addMessage (messages, Urgency::warning,
                    "The device has " + std::to_string (ceramics) + " ceramics, but the output has only "
                        + std::to_string (channels) + (channels == 1 ? " channel" : " channels") + ": ceramic "
                        + std::to_string (channels + 1) + " and above get nothing.");

    const auto followed = followingMessage (*player->following().status());
    addMessage (messages, followed.urgency, followed.text);
    return messages;
}

template <typename Sample>
void TouchProcessor::playFingers (const EffectBlock<Sample>& block)
{
    // A bounce does not depend on how quick the follower's windows are.
    const auto* const sensor = isNonRealtime() ? nullptr : block.sensor;

    if (isNonRealtime())
        player->waitUntilSettled (notes);

    auto now = controls->controls();
    now.isArmed = now.isArmed && ! block.isBypassed;
    player->process<Sample> ({ block.in, block.out, block.count, notes, sensor }, now);
}

void TouchProcessor::playChannels (const EffectBlock<float>& block)
{
    playFingers (block);
}

void TouchProcessor::playChannels (const EffectBlock<double>& block)
{
    playFingers (block);
}

/** As in AntinodeProcessor: a host is told of a step, and of another latency, as soon as the session has looked. */
TouchSettings TouchProcessor::readSettings()
{
    const auto now = controls->settings();
    const auto isLatencyNew = lookedLatency.exchange (now.latency) != now.latency;

    if (touches->retryWhenDue() || isLatencyNew || controls->stepReports().isWaiting())
        post();

    return now;
}
} // namespace antinode
