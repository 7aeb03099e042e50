#include "TouchProcessor.h"

#include "TouchContent.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <tuple>
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

/** It starts with a plate that is solved quickly: fingers rest on plates. */
TouchProcessor::TouchProcessor (int ceramics, WrapperType wrapper)
    : RoleProcessor ({ Bus { "Fingers", maximumFingers, maximumFingers }, { "Ceramics", ceramics }, true }, wrapper,
                     SessionRole::fingers, deviceDocument ("aluminium-200x120"))
{
    if (wrapper == wrapperType_VST3)
        parameters().stepReports().add (addStop());

    touches = std::make_unique<NetworkFingers> (
        parameters(), [this] { return inputs(); }, [this] { session().stopAll(); });
    start (std::tuple { *device() });
}

TouchProcessor::~TouchProcessor()
{
    touches->open ({ 0, 0, "127.0.0.1" }); // No touch stops a player that is gone.
    close();
}

void TouchProcessor::load (std::shared_ptr<const DeviceDocument> device)
{
    keep (device);

    if (device->description.requiresArming)
        parameters().arm().setValueNotifyingHost (0);

    session().load (std::move (device));
}

void TouchProcessor::loadFocus (const std::shared_ptr<const FocusDocument>& wanted)
{
    const auto now = focus();

    if ((now == nullptr) != (wanted == nullptr) || (now != nullptr && ! sayTheSame (*now, *wanted)))
        session().loadFocus (wanted);

    post();
}

SessionState TouchProcessor::state() const
{
    return { device(), focus(), values(), 0, false, session().following().settings() };
}

void TouchProcessor::setState (const SessionState& wanted, bool)
{
    setValues (wanted.parameters, *wanted.device);
    loadFocus (wanted.focus);
    session().following().setSettings (wanted.following);

    if (wanted.device->text != device()->text)
        load (wanted.device);
}

void TouchProcessor::setValues (const std::map<std::string, double>& wanted, const DeviceDocument& device)
{
    auto values = wanted;

    if (device.description.requiresArming)
        values["arm"] = 0;

    // Fingers that touch stay where they are.
    const auto now = parameters().values();

    for (const auto& key : touchedKeys ({ "x", "y", "state", "load" }))
        values[key] = now.at (key);

    parameters().setValues (values);
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
    auto values = parameters().values();
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

DeviceProcessor::Playing TouchProcessor::playing() const
{
    const auto now = session().snapshot();
    return { now->model, now->error, session().latencySamples (parameters().settings().latency), &session().meters(),
             &session().following() };
}

std::vector<UserMessage> TouchProcessor::ownMessages() const
{
    const auto now = session().snapshot();
    std::vector<UserMessage> messages;
    addMessage (messages, Urgency::warning, touches->failure());
    addMessage (messages, Urgency::warning, now->formatError);

    if (! now->designError.empty())
        addMessage (messages, Urgency::warning, now->designError + "; the filters before play on");

    if (const auto error = session().focusProgress().liveError; ! error.empty())
        addMessage (messages, Urgency::warning, "Notes play nothing: " + error);

    return messages;
}

/** A host is told of another latency, and a refused port is asked for again, as soon as the session has looked. */
TouchSettings TouchProcessor::look()
{
    const auto now = RoleProcessor::look();
    const auto isLatencyNew = lookedLatency.exchange (now.latency) != now.latency;

    if (touches->retryWhenDue() || isLatencyNew)
        post();

    return now;
}

juce::AudioProcessorEditor* TouchProcessor::createEditor()
{
    return editorAsLeft<TouchContent> (*this).release();
}
} // namespace antinode
