#include "TouchProcessor.h"

#include "TouchContent.h"

#include <Processor/ParameterSet.h>
#include <Processor/ParameterTypes.h>
#include <antinode_base/InputError.h>
#include <antinode_graph/InputNodes.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace antinode
{
namespace
{
constexpr double quietest = -60, loudest = 20; // dB
constexpr float quietestText = -60 + 1e-3F;    // below which it is called silent
constexpr double metresPerMicrometre = 1e-6;

/** Where fingers are at first, in % of the surface, far from each other; the first one plays. */
constexpr std::pair<double, double> firstFingers[mostFingers] = { { 30, 40 }, { 70, 60 }, { 30, 75 }, { 70, 25 },
                                                                  { 50, 50 }, { 15, 20 }, { 85, 80 }, { 50, 15 } };

FingerParameters addFinger (GroupBuilder& group, int index, const SurfaceSource& surface)
{
    const auto number = juce::String (index + 1), identifier = "finger" + number + "_", name = "Finger " + number + " ";
    const auto [x, y] = firstFingers[index];
    FingerParameters finger {};
    finger.x = group.number (identifier + "x", name + "x", "", { 0, 100 }, x, placeTexts (surface, SurfaceAxis::x));
    finger.y = group.number (identifier + "y", name + "y", "", { 0, 100 }, y, placeTexts (surface, SurfaceAxis::y));
    finger.presence = group.choice (identifier + "state", name + "state", { "absent", "silent", "plays" },
                                    static_cast<int> (index == 0 ? FingerPresence::plays : FingerPresence::absent));
    finger.level =
        group.number (identifier + "level", name + "level", "", { 0.01, 100, true }, 5, unitTexts ("\xC2\xB5m", 3));
    finger.load = group.choice (identifier + "load", name + "load", { "none", "light", "medium", "firm" });
    return finger;
}
} // namespace

TouchParameters::TouchParameters (juce::AudioProcessor& processor, const SurfaceSource& surface)
{
    for (int i = 0; i < mostFingers; ++i)
    {
        const auto number = juce::String (i + 1);
        GroupBuilder group (processor, "finger" + number, "Finger " + number, ordered);
        fingers[static_cast<std::size_t> (i)] = addFinger (group, i, surface);
        group.addToProcessor();
    }

    std::vector<juce::String> latencies;
    std::transform (touchLatencies.begin(), touchLatencies.end(), std::back_inserter (latencies),
                    [] (double latency) { return juce::String (juce::roundToInt (1000 * latency)) + " ms"; });
    GroupBuilder output (processor, "output", "Output", ordered);
    chosenLatency = output.choice ("latency", "Latency", latencies);
    outputGain =
        output.number ("gain", "Gain", "", { quietest, loudest }, 0, unitTexts ("dB", 1, quietestText, "silent"));
    armed = output.flag ("arm", "Arm", true, "armed", "disarmed", false);
    bypassed = output.flag ("bypass", "Bypass", false, "bypassed", "playing");
    output.addToProcessor();
    begin();
}

TouchSettings TouchParameters::settings() const
{
    TouchSettings now;

    for (std::size_t k = 0; k < fingers.size(); ++k)
        now.fingers[k] = { static_cast<float> (fingers[k].x->get()), static_cast<float> (fingers[k].y->get()),
                           static_cast<FingerPresence> (fingers[k].presence->get()),
                           static_cast<FingerLoad> (fingers[k].load->get()) };

    now.latency = static_cast<std::size_t> (chosenLatency->get());
    return now;
}

PlayControls TouchParameters::controls() const
{
    PlayControls now;
    const auto decibels = outputGain->get();
    const auto factor = decibels <= quietest ? 0.0 : std::pow (10, decibels / 20);

    for (std::size_t k = 0; k < fingers.size(); ++k)
        if (static_cast<FingerPresence> (fingers[k].presence->get()) == FingerPresence::plays)
            now.levels[k] = std::min (FilterNode::largestLevel, fingers[k].level->get() * metresPerMicrometre * factor);

    now.focusGain = std::min (1.0, factor);
    now.latency = static_cast<std::size_t> (chosenLatency->get());
    now.isArmed = *armed && ! *bypassed;
    return now;
}

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
        receiver = std::make_unique<TouchReceiver> (
            wantedPorts, options, [this] (const Touch& touch) { take (touch); }, control);
    }
    catch (const InputError& failure)
    {
        refusal = failure.what();
        isRefused = true;
        throw;
    }
}

void NetworkFingers::setControl (OscControl controlToUse)
{
    const std::lock_guard lock (mutex);
    control = std::move (controlToUse);
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
