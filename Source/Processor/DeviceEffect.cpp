#include "DeviceEffect.h"

#include "VST3Channels.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace antinode
{
juce::AudioProcessor::BusesProperties DeviceEffect::buses (const EffectBus& input, const EffectBus& output,
                                                           SensorBus sensor, WrapperType wrapper)
{
    auto made = BusesProperties()
                    .withInput (input.name, wireSet (input.channels, wrapper), true)
                    .withOutput (output.name, wireSet (output.channels, wrapper), true);

    // What is off at first is an optional port in LV2, and JUCE's wrapper reads those that are not connected, too.
    return sensor == SensorBus::one
               ? made.withInput ("Sensor", juce::AudioChannelSet::mono(), wrapper != wrapperType_VST3)
               : made;
}

DeviceEffect::DeviceEffect (const EffectBus& input, const EffectBus& output, SensorBus sensor, WrapperType wrapperToUse,
                            const char* schemaOfStates, const std::string& first)
    : AudioProcessor (buses (input, output, sensor, wrapperToUse)),
      VST3Extensions (static_cast<juce::AudioProcessor&> (*this)), inputBus (input), outputBus (output),
      sensorBus (sensor), wrapper (wrapperToUse), schema (schemaOfStates),
      loadedDevice (std::make_shared<const DeviceDocument> (
          readDeviceDocument (loadDocument (LibraryKind::device, first), "device '" + first + "'")))
{
}

void DeviceEffect::begin()
{
    orderWires();
    reportLatency(); // Hosts read it before they prepare.
    changes.begin();
}

void DeviceEffect::load (std::shared_ptr<const DeviceDocument> device)
{
    {
        const juce::ScopedLock lock (documents);
        loadedDevice = device;
        stateWarning.clear();
    }
    take (std::move (device));
}

std::shared_ptr<const DeviceDocument> DeviceEffect::device() const
{
    const juce::ScopedLock lock (documents);
    return loadedDevice;
}

DeviceState DeviceEffect::state() const
{
    return { device(), values(), keptFocus(), keptFollowing() };
}

void DeviceEffect::setState (const DeviceState& wanted)
{
    const auto isOtherDevice = wanted.device->text != device()->text;
    setValues (wanted.parameters, *wanted.device);
    takeFocus (wanted.focus);
    takeFollowing (wanted.following);

    if (isOtherDevice)
        load (wanted.device);
}

void DeviceEffect::getStateInformation (juce::MemoryBlock& block)
{
    const auto text = deviceStateToText (state(), schema);
    block.replaceAll (text.data(), text.size());
}

void DeviceEffect::setStateInformation (const void* data, int size)
{
    juce::String warning;

    try
    {
        setState (readDeviceState ({ static_cast<const char*> (data), static_cast<std::size_t> (std::max (0, size)) },
                                   schema));
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

std::vector<UserMessage> DeviceEffect::messages()
{
    auto messages = ownMessages();
    const juce::ScopedLock lock (documents);

    if (stateWarning.isNotEmpty())
        messages.insert (messages.begin(), { Urgency::warning, stateWarning.toStdString() });

    return messages;
}

bool DeviceEffect::isBusesLayoutSupported (const BusesLayout& layout) const
{
    // By count: hosts name channels as they like, wires are told apart by their numbers.
    const auto in = layout.getMainInputChannels(), out = layout.getMainOutputChannels();
    const auto sensors = sensorBus == SensorBus::one ? 1 : 0;
    return layout.inputBuses.size() <= 1 + sensors && layout.getNumChannels (true, 1) <= sensors && in >= 1
           && in <= inputBus.most && out >= 1 && out <= outputBus.most;
}

void DeviceEffect::orderWires()
{
    inputOrder = wireOrder (getBus (true, 0)->getCurrentLayout(), wrapper);
    outputOrder = wireOrder (getBus (false, 0)->getCurrentLayout(), wrapper);
    sensorChannel = getChannelCountOfBus (true, 1) > 0 ? getChannelIndexInProcessBlockBuffer (true, 1, 0) : -1;
}

void DeviceEffect::prepareToPlay (double sampleRate, int)
{
    orderWires();
    prepareSession (sampleRate);
    describedModel.prepare();
    reportLatency();
    changes.post();
}

template <typename Sample>
void DeviceEffect::play (juce::AudioBuffer<Sample>& buffer, const juce::MidiBuffer& midi, bool isBypassed)
{
    const juce::ScopedNoDenormals noDenormals;
    const auto wires =
        std::max (static_cast<int> (std::max (inputOrder.size(), outputOrder.size())), sensorChannel + 1);

    // A host that hands over fewer channels than it asked for gets silence rather than the wrong ceramics.
    if (buffer.getNumChannels() < wires)
    {
        buffer.clear();
        return;
    }

    std::array<const Sample*, mostChannels> in {};
    std::array<Sample*, mostChannels> out {};

    for (std::size_t k = 0; k < inputOrder.size(); ++k)
        in[k] = buffer.getReadPointer (inputOrder[k]);

    for (std::size_t k = 0; k < outputOrder.size(); ++k)
        out[k] = buffer.getWritePointer (outputOrder[k]);

    takeNotes (midi, buffer.getNumSamples());
    playChannels (EffectBlock<Sample> { { in.data(), inputOrder.size() },
                                        { out.data(), outputOrder.size() },
                                        buffer.getNumSamples(),
                                        isBypassed,
                                        sensorChannel >= 0 ? buffer.getReadPointer (sensorChannel) : nullptr });

    for (auto i = static_cast<int> (outputOrder.size()); i < buffer.getNumChannels(); ++i)
        buffer.clear (i, 0, buffer.getNumSamples());
}

template void DeviceEffect::play (juce::AudioBuffer<float>&, const juce::MidiBuffer&, bool);
template void DeviceEffect::play (juce::AudioBuffer<double>&, const juce::MidiBuffer&, bool);

/** As in AntinodeProcessor: who comes second leaves it to a message that follows. */
void DeviceEffect::reportLatency()
{
    const juce::ScopedTryLock lock (latencyReports);

    if (lock.isLocked())
        setLatencySamples (static_cast<int> (latencyToReport()));
    else
        changes.post();
}

void DeviceEffect::reportChanges()
{
    reportLatency();
    stepReports().tell();

    // As in AntinodeProcessor.
    if (const auto tail = getTailLengthSeconds(); std::exchange (toldTail, tail) != tail)
        updateHostDisplay (ChangeDetails().withLatencyChanged (true));

    if (describedModel.replace (solvedModel()))
        updateHostDisplay (ChangeDetails().withParameterInfoChanged (true));

    if (onChange)
        onChange();
}
} // namespace antinode
