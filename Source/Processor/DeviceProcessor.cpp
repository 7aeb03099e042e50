#include "DeviceProcessor.h"

#include "HostChannels.h"

#include <antinode_base/InputError.h>
#include <antinode_model/ModalModel.h>
#include <antinode_session/UserMessages.h>
#include <juce_events/juce_events.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace antinode
{
struct ChangeMessages::Link
{
    std::recursive_mutex mutex; ///< What is called may free us.
    std::function<void()> toCall;
    std::atomic<bool> isPosted { false };
    bool isOpen = false;
};

ChangeMessages::ChangeMessages (std::function<void()> toCall) : link (std::make_shared<Link>())
{
    link->toCall = std::move (toCall);
}

ChangeMessages::~ChangeMessages()
{
    end();
}

void ChangeMessages::begin()
{
    {
        const std::lock_guard lock (link->mutex);
        link->isOpen = true;
    }
    post();
}

void ChangeMessages::end()
{
    const std::lock_guard lock (link->mutex);
    link->isOpen = false;
}

void ChangeMessages::post()
{
    if (link->isPosted.exchange (true))
        return;

    juce::MessageManager::callAsync (
        [kept = link]
        {
            kept->isPosted = false;
            const std::lock_guard lock (kept->mutex);

            if (kept->isOpen)
                kept->toCall();
        });
}

juce::AudioProcessor::BusesProperties DeviceProcessor::properties (const Buses& buses, WrapperType wrapper)
{
    const auto isVST3 = wrapper == wrapperType_VST3;
    BusesProperties made;

    if (buses.input)
        made = made.withInput (buses.input->name, wireSet (buses.input->channels, wrapper), true);

    // What is off at first is an optional port in LV2, and JUCE's wrapper reads those that are not connected, too.
    if (buses.hasSensor)
        made = made.withInput ("Sensor", juce::AudioChannelSet::mono(), ! isVST3);

    made = made.withOutput (buses.output.name, wireSet (buses.output.channels, wrapper), true);

    if (buses.hasMonitor)
        made = made.withOutput (
            "Monitor",
            isVST3 ? juce::AudioChannelSet::stereo() : juce::AudioChannelSet::discreteChannels (mostMonitors), true);

    return made;
}

DeviceProcessor::DeviceProcessor (const Buses& busesToHave, WrapperType wrapperToUse, const SessionRole& roleToPlay,
                                  std::shared_ptr<const DeviceDocument> first)
    : AudioProcessor (properties (busesToHave, wrapperToUse)),
      VST3Extensions (static_cast<juce::AudioProcessor&> (*this)), loadedDevice (std::move (first)),
      buses (busesToHave), wrapper (wrapperToUse), role (roleToPlay)
{
}

void DeviceProcessor::begin()
{
    orderWires();
    reportLatency(); // Hosts read it before they prepare.
    changes.begin();
}

std::shared_ptr<const DeviceDocument> DeviceProcessor::device() const
{
    const juce::ScopedLock lock (documents);
    return loadedDevice;
}

void DeviceProcessor::keep (std::shared_ptr<const DeviceDocument> device)
{
    const juce::ScopedLock lock (documents);
    loadedDevice = std::move (device);
    stateWarning.clear();
}

void DeviceProcessor::getStateInformation (juce::MemoryBlock& block)
{
    const auto text = stateToText (state(), role);
    block.replaceAll (text.data(), text.size());
}

void DeviceProcessor::setStateInformation (const void* data, int size)
{
    juce::String warning;

    try
    {
        setState (readState ({ static_cast<const char*> (data), static_cast<std::size_t> (std::max (0, size)) }, role),
                  true);
    }
    catch (const InputError& failure)
    {
        warning = "The saved state could not be read; nothing was changed: " + juce::String::fromUTF8 (failure.what());
    }

    {
        const juce::ScopedLock lock (documents);
        stateWarning = warning;
    }
    changes.post();
}

UserMessage DeviceProcessor::missingChannels (const ModalModel* model) const
{
    const auto ceramics = model != nullptr ? static_cast<int> (model->actuators()) : 0;
    const auto isInput = role.takesVoltages;
    // Not the order of the channels: a host may be preparing us on another thread.
    const auto channels = getChannelCountOfBus (isInput, 0);

    if (ceramics <= channels)
        return {};

    return { Urgency::warning, "The device has " + std::to_string (ceramics) + " ceramics, but this bus has only "
                                   + std::to_string (channels) + (channels == 1 ? " channel" : " channels")
                                   + ": ceramic " + std::to_string (channels + 1) + " and above stay at 0 V." };
}

std::vector<UserMessage> DeviceProcessor::messages() const
{
    const auto now = playing();
    std::vector<UserMessage> messages;
    {
        const juce::ScopedLock lock (documents);
        addMessage (messages, Urgency::warning, stateWarning.toStdString());
    }

    if (now.meters != nullptr && now.meters->isMutedForBadNumbers())
        addMessage (messages, Urgency::warning,
                    "A sample was not a finite number: all voltages are 0 V until playback starts again.");

    addMessage (messages, Urgency::warning, now.error);

    for (const auto& [urgency, text] : ownMessages())
        addMessage (messages, urgency, text);

    addMessage (messages, Urgency::warning, missingChannels (now.model.get()).text);

    if (now.following != nullptr)
    {
        const auto followed = followingMessage (*now.following->status());
        addMessage (messages, followed.urgency, followed.text);
    }

    return messages;
}

juce::String DeviceProcessor::warning() const
{
    return juce::String::fromUTF8 (firstWarning (messages()).c_str());
}

bool DeviceProcessor::isBusesLayoutSupported (const BusesLayout& layout) const
{
    // By count: hosts name channels as they like, wires are distinguished by their numbers.
    const auto isWithin = [] (int channels, const Bus& bus) { return channels >= 1 && channels <= bus.most; };
    const auto sensors = buses.hasSensor ? 1 : 0;
    return layout.inputBuses.size() <= sensorBus() + sensors && layout.getNumChannels (true, sensorBus()) <= sensors
           && (! buses.input || isWithin (layout.getMainInputChannels(), *buses.input))
           && isWithin (layout.getMainOutputChannels(), buses.output)
           && layout.getNumChannels (false, 1) <= (buses.hasMonitor ? mostMonitors : 0);
}

void DeviceProcessor::orderWires()
{
    inputOrder = buses.input ? wireOrder (getBus (true, 0)->getCurrentLayout(), wrapper) : std::vector<int>();
    outputOrder = wireOrder (getBus (false, 0)->getCurrentLayout(), wrapper);
    monitors = static_cast<std::size_t> (getChannelCountOfBus (false, 1));

    for (std::size_t i = 0; i < monitors; ++i)
        outputOrder.push_back (getChannelIndexInProcessBlockBuffer (false, 1, static_cast<int> (i)));

    sensorChannel = getChannelCountOfBus (true, sensorBus()) > 0 && buses.hasSensor
                        ? getChannelIndexInProcessBlockBuffer (true, sensorBus(), 0)
                        : -1;
}

void DeviceProcessor::prepareToPlay (double sampleRate, int)
{
    orderWires();
    prepareSession (sampleRate);
    describedModel.prepare();
    reportLatency();
    changes.post();
}

template <typename Sample>
bool DeviceProcessor::wire (juce::AudioBuffer<Sample>& buffer, const juce::MidiBuffer& midi, WiredBlock<Sample>& wired)
{
    const auto count = buffer.getNumSamples();
    const auto wires =
        std::max (static_cast<int> (std::max (inputOrder.size(), outputOrder.size())), sensorChannel + 1);

    // A host that hands over fewer channels than it asked for gets silence rather than the wrong ceramics.
    if (buffer.getNumChannels() < wires)
    {
        buffer.clear();
        return false;
    }

    for (std::size_t k = 0; k < inputOrder.size(); ++k)
        wired.inputs[k] = buffer.getReadPointer (inputOrder[k]);

    for (std::size_t k = 0; k < outputOrder.size(); ++k)
        wired.outputs[k] = buffer.getWritePointer (outputOrder[k]);

    const auto main = outputOrder.size() - monitors;
    wired.block = { { wired.inputs.data(), inputOrder.size() },
                    { wired.outputs.data(), main },
                    { wired.outputs.data() + main, monitors },
                    count,
                    acceptsMidi() ? triggers.read (midi, count) : std::span<const FocusEvent>(),
                    sensorChannel >= 0 ? buffer.getReadPointer (sensorChannel) : nullptr };

    if (isNonRealtime())
    {
        waitUntilSettled (wired.block.events);
        wired.block.sensor = nullptr; // A bounce does not depend on how quick its windows are.
    }

    return true;
}

template bool DeviceProcessor::wire (juce::AudioBuffer<float>&, const juce::MidiBuffer&, WiredBlock<float>&);
template bool DeviceProcessor::wire (juce::AudioBuffer<double>&, const juce::MidiBuffer&, WiredBlock<double>&);

/** A host prepares us on a thread of its own while messages run on another. Who comes second leaves it to a message
   that follows: to wait would block a host that waits for the other thread when informed of the latency. */
void DeviceProcessor::reportLatency()
{
    const juce::ScopedTryLock lock (latencyReports);

    if (lock.isLocked())
        setLatencySamples (static_cast<int> (playing().latency));
    else
        changes.post();
}

void DeviceProcessor::reportSteps()
{
    if (parameterSet().stepReports().isWaiting())
        changes.post();
}

void DeviceProcessor::reportChanges()
{
    reportLatency();
    parameterSet().stepReports().tell();

    // JUCE has no message of its own for it.
    if (const auto tail = getTailLengthSeconds(); std::exchange (toldTail, tail) != tail)
        updateHostDisplay (ChangeDetails().withLatencyChanged (true));

    if (describedModel.replace (playing().model))
        updateHostDisplay (ChangeDetails().withParameterInfoChanged (true));

    if (onChange)
        onChange();
}
} // namespace antinode
