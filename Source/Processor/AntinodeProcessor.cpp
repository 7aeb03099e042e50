#include "AntinodeProcessor.h"

#include "VST3Channels.h"

#include <antinode_session/FollowingWords.h>

#include <utility>

namespace antinode
{
std::function<juce::AudioProcessorEditor*(AntinodeProcessor&)> AntinodeProcessor::makeEditor;

juce::AudioProcessor::BusesProperties AntinodeProcessor::busesFor (int ceramics, WrapperType wrapper)
{
    const auto monitor = wrapper == wrapperType_VST3
                             ? juce::AudioChannelSet::stereo()
                             : juce::AudioChannelSet::discreteChannels (BufferChannels::maximumMonitors);
    // What is off at first is an optional port in LV2, and JUCE's wrapper reads those that are not connected, too.
    return BusesProperties()
        .withInput ("Sensor", juce::AudioChannelSet::mono(), wrapper != wrapperType_VST3)
        .withOutput ("Ceramics", wireSet (ceramics, wrapper), true)
        .withOutput ("Monitor", monitor, true);
}

AntinodeProcessor::AntinodeProcessor (int ceramics, WrapperType wrapperToUse)
    : AudioProcessor (busesFor (ceramics, wrapperToUse)), VST3Extensions (static_cast<juce::AudioProcessor&> (*this)),
      wrapper (wrapperToUse)
{
    const auto start = demonstrator();
    loadedDevice = start.device;
    loadedFocus = touchedFocus = start.focus;
    controls = std::make_unique<Parameters> (*this, [this]
                                             { return player != nullptr ? player->snapshot()->model : nullptr; });

    if (wrapper == wrapperType_VST3)
        controls->stepReports().add (addStop());

    controls->setFocus (settingsFromFocus (loadedFocus->description, deviceExtent (loadedDevice->description), {}));
    player = std::make_unique<Session> (
        *loadedDevice, *loadedFocus, [this] { return readSettings(); }, [this] { changes.post(); },
        [this] (const auto& chosen, const auto& before) { return takeFocus (chosen, before); });
    bufferChannels.lay (*this, wrapper);
    changes.begin();
}

AntinodeProcessor::~AntinodeProcessor()
{
    changes.end();
}

void AntinodeProcessor::load (std::shared_ptr<const DeviceDocument> newDevice,
                              std::shared_ptr<const FocusDocument> newFocus)
{
    {
        const juce::ScopedLock lock (documents);

        // The same device again is no other one: its focus stays.
        if (newDevice != nullptr && newFocus == nullptr && newDevice->text == loadedDevice->text)
            newFocus = loadedFocus;

        if (newDevice != nullptr)
            loadedDevice = newDevice;

        if (newFocus != nullptr)
            loadedFocus = touchedFocus = newFocus;

        stateWarning.clear();
    }

    if (newDevice != nullptr)
        mutedCeramics = 0;

    if (newDevice != nullptr && newDevice->description.requiresArming)
        controls->arm().setValueNotifyingHost (0);

    controls->setFocus (
        settingsFromFocus (focus()->description, deviceExtent (device()->description), controls->settings()));
    player->load (std::move (newDevice), std::move (newFocus));
}

/** On the session's thread. Parameters follow at once, so that nothing else is designed. */
bool AntinodeProcessor::takeFocus (const std::shared_ptr<const FocusDocument>& chosen, const FocusDocument& before)
{
    {
        const juce::ScopedLock lock (documents);

        if (! sayTheSame (*touchedFocus, before))
            return false;

        loadedFocus = touchedFocus = chosen;
    }
    controls->setFocus (
        settingsFromFocus (chosen->description, deviceExtent (device()->description), controls->settings()));
    changes.post();
    return true;
}

std::shared_ptr<const DeviceDocument> AntinodeProcessor::device() const
{
    const juce::ScopedLock lock (documents);
    return loadedDevice;
}

std::shared_ptr<const FocusDocument> AntinodeProcessor::focus() const
{
    const juce::ScopedLock lock (documents);
    return touchedFocus;
}

std::vector<UserMessage> AntinodeProcessor::messages() const
{
    const auto now = player->snapshot();
    const auto progress = player->progress();
    // Not the order of the channels: a host may be preparing us on another thread.
    const auto channels = getChannelCountOfBus (false, 0);
    const auto ceramics = now->model != nullptr ? static_cast<int> (now->model->actuators()) : 0;
    std::vector<UserMessage> messages;
    {
        const juce::ScopedLock lock (documents);
        addMessage (messages, Urgency::warning, stateWarning.toStdString());
    }
    if (player->meters().isMutedForBadNumbers())
        addMessage (messages, Urgency::warning,
                    "The output is muted because a sample was not finite. Load the device again.");

    addMessage (messages, Urgency::warning, now->deviceError);

    // Those of the device before are over.
    if (! now->isSolving)
        addMessage (messages, Urgency::warning, progress.liveError);

    if (ceramics > channels)
        addMessage (messages, Urgency::warning,
                    "The device has " + std::to_string (ceramics) + " ceramics, but this bus has only "
                        + std::to_string (channels) + " channels: ceramic " + std::to_string (channels + 1)
                        + " and above stay at 0 V.");

    const auto followed = followingMessage (*player->following().status());
    addMessage (messages, followed.urgency, followed.text);
    return messages;
}

void AntinodeProcessor::setWarning (const juce::String& text)
{
    {
        const juce::ScopedLock lock (documents);
        stateWarning = text;
    }
    changes.post();
}

bool AntinodeProcessor::isBusesLayoutSupported (const BusesLayout& layout) const
{
    // By count: hosts name channels as they like, wires are distinguished by their numbers.
    const auto ceramics = layout.getMainOutputChannels();
    const auto monitor = layout.getNumChannels (false, 1);
    const auto sensors = layout.getNumChannels (true, 0);
    return layout.inputBuses.size() == 1 && sensors <= 1 && ceramics >= 1 && ceramics <= maximumCeramics
           && monitor <= BufferChannels::maximumMonitors;
}

void AntinodeProcessor::prepareToPlay (double sampleRate, int)
{
    bufferChannels.lay (*this, wrapper);
    player->prepare (sampleRate);
    describedModel.prepare();
    reportLatency();
    changes.post();
}

void AntinodeProcessor::reset()
{
    player->stopAll();
}

template <typename Sample>
void AntinodeProcessor::play (juce::AudioBuffer<Sample>& buffer, const juce::MidiBuffer& midi, bool isBypassed)
{
    const juce::ScopedNoDenormals noDenormals;
    BufferChannels::Pointers<Sample> pointers;
    auto block = bufferChannels.makeBlock (buffer, pointers);

    // A host that hands over fewer channels than it asked for gets silence rather than the wrong ceramics.
    if (! block)
    {
        buffer.clear();
        return;
    }

    auto now = controls->controls();
    now.isArmed = now.isArmed && ! isBypassed;
    now.mutes = mutedCeramics;
    const auto events = triggers.read (midi, buffer.getNumSamples());

    if (isNonRealtime())
    {
        player->waitUntilSettled (events);
        block->sensor = nullptr; // A bounce does not depend on how quick its windows are.
    }

    player->process (*block, events, now);
}

void AntinodeProcessor::processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi)
{
    play (buffer, midi, false);
}

void AntinodeProcessor::processBlock (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi)
{
    play (buffer, midi, false);
}

void AntinodeProcessor::processBlockBypassed (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi)
{
    play (buffer, midi, true);
}

void AntinodeProcessor::processBlockBypassed (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi)
{
    play (buffer, midi, true);
}

/** A host prepares us on a thread of its own while messages run on another. Who comes second leaves it to a message
   that follows: to wait would block a host that waits for the other thread when informed of the latency. */
void AntinodeProcessor::reportLatency()
{
    const juce::ScopedTryLock lock (latencyReports);

    if (lock.isLocked())
        setLatencySamples (static_cast<int> (player->latencySamples()));
    else
        changes.post();
}

/** The session looks every few milliseconds: that is how soon a host is told of a step, too. */
PlaySettings AntinodeProcessor::readSettings()
{
    if (controls->stepReports().isWaiting())
        changes.post();

    return controls->settings();
}

void AntinodeProcessor::reportChanges()
{
    reportLatency();
    controls->stepReports().tell();

    // JUCE has no message of its own for it.
    if (const auto tail = getTailLengthSeconds(); std::exchange (toldTail, tail) != tail)
        updateHostDisplay (ChangeDetails().withLatencyChanged (true));

    if (describedModel.replace (player->snapshot()->model))
        updateHostDisplay (ChangeDetails().withParameterInfoChanged (true));

    if (onChange)
        onChange();
}
} // namespace antinode
