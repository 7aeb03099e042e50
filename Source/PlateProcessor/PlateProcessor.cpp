#include "PlateProcessor.h"

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
/** The device of the demonstrator: what everything starts with. */
DeviceDocument firstDevice()
{
    return readDeviceDocument (loadDocument (LibraryKind::device, "staple"), "device 'staple'");
}
} // namespace

std::function<juce::AudioProcessorEditor*(PlateProcessor&)> PlateProcessor::makeEditor;

juce::AudioProcessor::BusesProperties PlateProcessor::busesFor (int ceramics, WrapperType wrapper)
{
    return BusesProperties()
        .withInput ("Voltages", wireSet (ceramics, wrapper), true)
        .withOutput ("Probes", wireSet (maximumProbes, wrapper), true);
}

PlateProcessor::PlateProcessor (int ceramics, WrapperType wrapperToUse)
    : AudioProcessor (busesFor (ceramics, wrapperToUse)), wrapper (wrapperToUse),
      loadedDevice (std::make_shared<const DeviceDocument> (firstDevice()))
{
    controls = std::make_unique<PlateParameters> (
        *this, [this] { return surface != nullptr ? surface->snapshot()->model : nullptr; });
    surface = std::make_unique<PlateSession> (
        *loadedDevice, [this] { return readSettings(); }, [this] { changes.post(); });
    inputOrder = wireOrder (getBus (true, 0)->getCurrentLayout(), wrapper);
    outputOrder = wireOrder (getBus (false, 0)->getCurrentLayout(), wrapper);
    reportLatency(); // Hosts read it before they prepare.
    changes.begin();
}

PlateProcessor::~PlateProcessor()
{
    changes.end();
}

void PlateProcessor::load (std::shared_ptr<const DeviceDocument> device)
{
    {
        const juce::ScopedLock lock (documents);
        loadedDevice = device;
        stateWarning.clear();
    }
    surface->load (std::move (device));
}

std::shared_ptr<const DeviceDocument> PlateProcessor::device() const
{
    const juce::ScopedLock lock (documents);
    return loadedDevice;
}

DeviceState PlateProcessor::state() const
{
    return { device(), controls->values() };
}

void PlateProcessor::setState (const DeviceState& wanted)
{
    const auto isOtherDevice = wanted.device->text != device()->text;
    controls->setValues (wanted.parameters);

    if (isOtherDevice)
        load (wanted.device);
}

void PlateProcessor::getStateInformation (juce::MemoryBlock& block)
{
    const auto text = deviceStateToText (state(), plateSchema);
    block.replaceAll (text.data(), text.size());
}

void PlateProcessor::setStateInformation (const void* data, int size)
{
    juce::String warning;

    try
    {
        setState (readDeviceState ({ static_cast<const char*> (data), static_cast<std::size_t> (std::max (0, size)) },
                                   plateSchema));
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

juce::String PlateProcessor::warning()
{
    const auto now = surface->snapshot();
    const auto channels = getChannelCountOfBus (true, 0);
    const auto ceramics = now->model != nullptr ? static_cast<int> (now->model->actuators()) : 0;
    const juce::ScopedLock lock (documents);

    if (stateWarning.isNotEmpty())
        return stateWarning;

    if (! now->error.empty())
        return juce::String::fromUTF8 (now->error.c_str());

    if (surface->meters().isMutedForBadNumbers())
        return "A voltage was not a finite number: the surface gets 0 V until playback starts again.";

    if (ceramics > channels)
        return "The device has " + juce::String (ceramics) + " ceramics, but the input has only "
               + juce::String (channels) + (channels == 1 ? " channel" : " channels") + ": ceramics "
               + juce::String (channels + 1) + " and up get 0 V.";

    return {};
}

bool PlateProcessor::isBusesLayoutSupported (const BusesLayout& layout) const
{
    // By count: hosts name channels as they like, wires are told apart by their numbers.
    const auto ceramics = layout.getMainInputChannels(), probes = layout.getMainOutputChannels();
    return ceramics >= 1 && ceramics <= maximumCeramics && probes >= 1 && probes <= maximumProbes;
}

void PlateProcessor::prepareToPlay (double sampleRate, int)
{
    inputOrder = wireOrder (getBus (true, 0)->getCurrentLayout(), wrapper);
    outputOrder = wireOrder (getBus (false, 0)->getCurrentLayout(), wrapper);
    surface->prepare (sampleRate);
    reportLatency();
    changes.post();
}

template <typename Sample>
void PlateProcessor::play (juce::AudioBuffer<Sample>& buffer, bool isBypassed)
{
    const juce::ScopedNoDenormals noDenormals;
    const auto wires = static_cast<int> (std::max (inputOrder.size(), outputOrder.size()));

    // A host that hands over fewer channels than it asked for gets silence rather than the wrong ceramics.
    if (buffer.getNumChannels() < wires)
    {
        buffer.clear();
        return;
    }

    std::array<const Sample*, maximumCeramics> voltages {};
    std::array<Sample*, maximumProbes> probes {};

    for (std::size_t k = 0; k < inputOrder.size(); ++k)
        voltages[k] = buffer.getReadPointer (inputOrder[k]);

    for (std::size_t k = 0; k < outputOrder.size(); ++k)
        probes[k] = buffer.getWritePointer (outputOrder[k]);

    if (isNonRealtime())
        surface->waitUntilSettled();

    auto now = controls->controls();
    now.isPlaying = now.isPlaying && ! isBypassed;
    surface->process<Sample> (
        { { voltages.data(), inputOrder.size() }, { probes.data(), outputOrder.size() }, buffer.getNumSamples() }, now);

    for (auto i = static_cast<int> (outputOrder.size()); i < buffer.getNumChannels(); ++i)
        buffer.clear (i, 0, buffer.getNumSamples());
}

void PlateProcessor::processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer&)
{
    play (buffer, false);
}

void PlateProcessor::processBlock (juce::AudioBuffer<double>& buffer, juce::MidiBuffer&)
{
    play (buffer, false);
}

void PlateProcessor::processBlockBypassed (juce::AudioBuffer<float>& buffer, juce::MidiBuffer&)
{
    play (buffer, true);
}

void PlateProcessor::processBlockBypassed (juce::AudioBuffer<double>& buffer, juce::MidiBuffer&)
{
    play (buffer, true);
}

/** As in AntinodeProcessor: who comes second leaves it to a message that follows. */
void PlateProcessor::reportLatency()
{
    const juce::ScopedTryLock lock (latencyReports);

    if (lock.isLocked())
        setLatencySamples (static_cast<int> (surface->latencySamples()));
    else
        changes.post();
}

/** As in AntinodeProcessor: a host is told of a step as soon as the session has looked. */
SurfaceSettings PlateProcessor::readSettings()
{
    if (controls->stepReports().isWaiting())
        changes.post();

    return controls->settings();
}

void PlateProcessor::reportChanges()
{
    reportLatency();
    controls->stepReports().tell();

    // Texts of places are in mm of the device.
    if (auto model = surface->snapshot()->model; model != describedModel)
    {
        describedModel = std::move (model);
        updateHostDisplay (ChangeDetails().withParameterInfoChanged (true));
    }

    if (onChange)
        onChange();
}
} // namespace antinode
