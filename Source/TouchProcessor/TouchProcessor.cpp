#include "TouchProcessor.h"

#include <Processor/VST3Channels.h>

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace antinode
{
namespace
{
/** A plate that is solved quickly: fingers rest on plates. */
DeviceDocument firstPlate()
{
    return readDeviceDocument (loadDocument (LibraryKind::device, "aluminium-200x120"), "device 'aluminium-200x120'");
}
} // namespace

std::function<juce::AudioProcessorEditor*(TouchProcessor&)> TouchProcessor::makeEditor;

juce::AudioProcessor::BusesProperties TouchProcessor::busesFor (int ceramics, WrapperType wrapper)
{
    return BusesProperties()
        .withInput ("Fingers", wireSet (maximumFingers, wrapper), true)
        .withOutput ("Ceramics", wireSet (ceramics, wrapper), true);
}

TouchProcessor::TouchProcessor (int ceramics, WrapperType wrapperToUse)
    : AudioProcessor (busesFor (ceramics, wrapperToUse)), wrapper (wrapperToUse),
      loadedDevice (std::make_shared<const DeviceDocument> (firstPlate()))
{
    controls = std::make_unique<TouchParameters> (*this, [this]
                                                  { return player != nullptr ? player->snapshot()->model : nullptr; });
    player = std::make_unique<TouchSession> (
        *loadedDevice, [this] { return readSettings(); }, [this] { changes.post(); });
    inputOrder = wireOrder (getBus (true, 0)->getCurrentLayout(), wrapper);
    outputOrder = wireOrder (getBus (false, 0)->getCurrentLayout(), wrapper);
    reportLatency(); // Hosts read it before they prepare.
    changes.begin();
}

TouchProcessor::~TouchProcessor()
{
    changes.end();
}

void TouchProcessor::load (std::shared_ptr<const DeviceDocument> device)
{
    {
        const juce::ScopedLock lock (documents);
        loadedDevice = device;
        stateWarning.clear();
    }

    if (device->description.requiresArming)
        controls->arm().setValueNotifyingHost (0);

    player->load (std::move (device));
}

std::shared_ptr<const DeviceDocument> TouchProcessor::device() const
{
    const juce::ScopedLock lock (documents);
    return loadedDevice;
}

DeviceState TouchProcessor::state() const
{
    return { device(), controls->values() };
}

void TouchProcessor::setState (const DeviceState& wanted)
{
    const auto isOtherDevice = wanted.device->text != device()->text;
    auto values = wanted.parameters;

    if (wanted.device->description.requiresArming)
        values["arm"] = 0;

    controls->setValues (values);

    if (isOtherDevice)
        load (wanted.device);
}

void TouchProcessor::getStateInformation (juce::MemoryBlock& block)
{
    const auto text = deviceStateToText (state(), touchSchema);
    block.replaceAll (text.data(), text.size());
}

void TouchProcessor::setStateInformation (const void* data, int size)
{
    juce::String warning;

    try
    {
        setState (readDeviceState ({ static_cast<const char*> (data), static_cast<std::size_t> (std::max (0, size)) },
                                   touchSchema));
    }
    catch (const InputError& failure)
    {
        warning =
            "The saved state could not be read, so nothing was changed: " + juce::String::fromUTF8 (failure.what());
    }

    {
        const juce::ScopedLock lock (documents);
        stateWarning = warning;
    }
    changes.post();
}

juce::String TouchProcessor::warning()
{
    const auto now = player->snapshot();
    const auto channels = getChannelCountOfBus (false, 0);
    const auto ceramics = now->model != nullptr ? static_cast<int> (now->model->actuators()) : 0;
    const juce::ScopedLock lock (documents);

    if (stateWarning.isNotEmpty())
        return stateWarning;

    if (! now->error.empty())
        return juce::String::fromUTF8 (now->error.c_str());

    if (! now->formatError.empty())
        return juce::String::fromUTF8 (now->formatError.c_str());

    if (! now->designError.empty())
        return juce::String::fromUTF8 (now->designError.c_str()) + "; the filters before play on";

    if (player->meters().isMutedForBadNumbers())
        return "A voltage was not a finite number: all voltages are 0 V until playback starts again.";

    if (ceramics > channels)
        return "The device has " + juce::String (ceramics) + " ceramics, but the output has only "
               + juce::String (channels) + (channels == 1 ? " channel" : " channels") + ": ceramic "
               + juce::String (channels + 1) + " and above get nothing.";

    return {};
}

bool TouchProcessor::isBusesLayoutSupported (const BusesLayout& layout) const
{
    // By count: hosts name channels as they like, wires are told apart by their numbers.
    const auto fingers = layout.getMainInputChannels(), ceramics = layout.getMainOutputChannels();
    return fingers >= 1 && fingers <= maximumFingers && ceramics >= 1 && ceramics <= maximumCeramics;
}

void TouchProcessor::prepareToPlay (double sampleRate, int)
{
    inputOrder = wireOrder (getBus (true, 0)->getCurrentLayout(), wrapper);
    outputOrder = wireOrder (getBus (false, 0)->getCurrentLayout(), wrapper);
    player->prepare (sampleRate, inputs());
    reportLatency();
    changes.post();
}

template <typename Sample>
void TouchProcessor::play (juce::AudioBuffer<Sample>& buffer, bool isBypassed)
{
    const juce::ScopedNoDenormals noDenormals;
    const auto wires = static_cast<int> (std::max (inputOrder.size(), outputOrder.size()));

    // A host that hands over fewer channels than it asked for gets silence rather than the wrong ceramics.
    if (buffer.getNumChannels() < wires)
    {
        buffer.clear();
        return;
    }

    std::array<const Sample*, maximumFingers> fingers {};
    std::array<Sample*, maximumCeramics> ceramics {};

    for (std::size_t k = 0; k < inputOrder.size(); ++k)
        fingers[k] = buffer.getReadPointer (inputOrder[k]);

    for (std::size_t k = 0; k < outputOrder.size(); ++k)
        ceramics[k] = buffer.getWritePointer (outputOrder[k]);

    if (isNonRealtime())
        player->waitUntilSettled();

    auto now = controls->controls();
    now.isArmed = now.isArmed && ! isBypassed;
    player->process<Sample> (
        { { fingers.data(), inputOrder.size() }, { ceramics.data(), outputOrder.size() }, buffer.getNumSamples() },
        now);

    for (auto i = static_cast<int> (outputOrder.size()); i < buffer.getNumChannels(); ++i)
        buffer.clear (i, 0, buffer.getNumSamples());
}

void TouchProcessor::processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer&)
{
    play (buffer, false);
}

void TouchProcessor::processBlock (juce::AudioBuffer<double>& buffer, juce::MidiBuffer&)
{
    play (buffer, false);
}

void TouchProcessor::processBlockBypassed (juce::AudioBuffer<float>& buffer, juce::MidiBuffer&)
{
    play (buffer, true);
}

void TouchProcessor::processBlockBypassed (juce::AudioBuffer<double>& buffer, juce::MidiBuffer&)
{
    play (buffer, true);
}

/** As in AntinodeProcessor: who comes second leaves it to a message that follows. */
void TouchProcessor::reportLatency()
{
    const juce::ScopedTryLock lock (latencyReports);

    if (lock.isLocked())
        setLatencySamples (static_cast<int> (player->latencySamples (controls->settings().latency)));
    else
        changes.post();
}

/** As in AntinodeProcessor: a host is told of a step, and of another latency, as soon as the session has looked. */
TouchSettings TouchProcessor::readSettings()
{
    const auto now = controls->settings();
    const auto isLatencyNew = lookedLatency.exchange (now.latency) != now.latency;

    if (isLatencyNew || controls->stepReports().isWaiting())
        changes.post();

    return now;
}

void TouchProcessor::reportChanges()
{
    reportLatency();
    controls->stepReports().tell();

    // Texts of places are in mm of the device.
    if (auto model = player->snapshot()->model; model != describedModel)
    {
        describedModel = std::move (model);
        updateHostDisplay (ChangeDetails().withParameterInfoChanged (true));
    }

    if (onChange)
        onChange();
}
} // namespace antinode
