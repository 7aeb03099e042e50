#include "AntinodeProcessor.h"

#include "VST3Channels.h"

#include <antinode_library/Library.h>
#include <antinode_model/InputError.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
constexpr int monitorChannels = 2;

juce::AudioChannelSet ceramicSet (int channels, juce::AudioProcessor::WrapperType wrapper)
{
    return wrapper == juce::AudioProcessor::wrapperType_VST3 ? vst3ChannelSet (channels)
                                                             : juce::AudioChannelSet::discreteChannels (channels);
}
} // namespace

std::function<juce::AudioProcessorEditor*(AntinodeProcessor&)> AntinodeProcessor::makeEditor;

SessionState demonstrator()
{
    const auto focus = loadDocument (LibraryKind::focus, "demonstrator");
    const auto device = loadDocument (LibraryKind::device, "staple");
    return { std::make_shared<const DeviceDocument> (readDeviceDocument (device, "device 'staple'")),
             std::make_shared<const FocusDocument> (readFocusDocument (focus, "focus 'demonstrator'")),
             {},
             0 };
}

juce::AudioProcessor::BusesProperties AntinodeProcessor::busesFor (int ceramics, WrapperType wrapper)
{
    const auto monitor = wrapper == wrapperType_VST3 ? juce::AudioChannelSet::stereo()
                                                     : juce::AudioChannelSet::discreteChannels (monitorChannels);
    return BusesProperties()
        .withOutput ("Ceramics", ceramicSet (ceramics, wrapper), true)
        .withOutput ("Monitor", monitor, true);
}

AntinodeProcessor::AntinodeProcessor (int ceramics, WrapperType wrapperToUse)
    : AudioProcessor (busesFor (ceramics, wrapperToUse)), wrapper (wrapperToUse)
{
    const auto start = demonstrator();
    loadedDevice = start.device;
    loadedFocus = start.focus;
    controls = std::make_unique<Parameters> (*this, [this]
                                             { return player != nullptr ? player->snapshot()->model : nullptr; });
    controls->setFocus (settingsOf (loadedFocus->description, extentOf (loadedDevice->description), {}));
    player = std::make_unique<Session> (
        *loadedDevice, *loadedFocus, [this] { return controls->settings(); }, [this] { changes.post(); });
    layChannels();
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

        if (newDevice != nullptr)
            loadedDevice = newDevice;

        if (newFocus != nullptr)
            loadedFocus = newFocus;
    }

    if (newDevice != nullptr)
        mutedCeramics = 0;

    if (newDevice != nullptr && newDevice->description.requiresArming)
        controls->arm().setValueNotifyingHost (0);

    controls->setFocus (settingsOf (focus()->description, extentOf (device()->description), controls->settings()));
    player->load (std::move (newDevice), std::move (newFocus));
}

SessionState AntinodeProcessor::state() const
{
    return { device(), focus(), controls->values(), mutes() };
}

void AntinodeProcessor::setState (const SessionState& wanted, bool isRestored)
{
    const auto isOtherDevice = wanted.device->text != device()->text,
               isOtherFocus = wanted.focus->text != focus()->text;
    {
        const juce::ScopedLock lock (documents);
        loadedDevice = wanted.device;
        loadedFocus = wanted.focus;
    }
    auto values = wanted.parameters;

    if (isRestored && wanted.device->description.requiresArming)
        values["arm"] = 0;

    controls->setValues (values);
    mutedCeramics = wanted.mutes;
    player->load (isOtherDevice ? wanted.device : nullptr, isOtherFocus ? wanted.focus : nullptr);
}

std::shared_ptr<const DeviceDocument> AntinodeProcessor::device() const
{
    const juce::ScopedLock lock (documents);
    return loadedDevice;
}

std::shared_ptr<const FocusDocument> AntinodeProcessor::focus() const
{
    const juce::ScopedLock lock (documents);
    return loadedFocus;
}

juce::String AntinodeProcessor::warning() const
{
    const auto now = player->snapshot();
    // Not the order of the channels: a host may be preparing us on another thread.
    const auto channels = getChannelCountOfBus (false, 0);
    const auto ceramics = now->model != nullptr ? static_cast<int> (now->model->actuators()) : 0;
    const juce::ScopedLock lock (documents);

    if (stateWarning.isNotEmpty())
        return stateWarning;

    if (! now->deviceError.empty())
        return juce::String::fromUTF8 (now->deviceError.c_str());

    if (const auto error = player->progress().liveError; ! error.empty())
        return juce::String::fromUTF8 (error.c_str());

    if (ceramics > channels)
        return "The device has " + juce::String (ceramics) + " ceramics, but this bus has only "
               + juce::String (channels) + " channels: ceramics " + juce::String (channels + 1)
               + " and up get nothing.";

    return {};
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
    // By count: hosts name channels as they like, wires are told apart by their numbers.
    const auto ceramics = layout.getMainOutputChannels();
    const auto monitor = layout.getNumChannels (false, 1);
    return layout.inputBuses.isEmpty() && ceramics >= 1 && ceramics <= mostCeramics && monitor <= monitorChannels;
}

/** Which channel of the buffer is which wire, for the layout that the host has chosen. */
void AntinodeProcessor::layChannels()
{
    const auto* const main = getBus (false, 0);
    const auto layout = main->getCurrentLayout();
    ceramicOrder.resize (static_cast<std::size_t> (layout.size()));

    if (wrapper == wrapperType_VST3)
        ceramicOrder = vst3ChannelOrder (layout);
    else
        std::iota (ceramicOrder.begin(), ceramicOrder.end(), 0);

    firstMonitor = layout.size();
    monitors = getChannelCountOfBus (false, 1);
}

void AntinodeProcessor::prepareToPlay (double sampleRate, int)
{
    layChannels();
    player->prepare (sampleRate, isNonRealtime());
    setLatencySamples (static_cast<int> (player->latencySamples()));
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
    std::array<Sample*, mostCeramics> ceramics {};
    std::array<Sample*, monitorChannels> monitor {};
    const auto wires = static_cast<int> (ceramicOrder.size());

    // A host that hands over fewer channels than it asked for gets silence rather than the wrong ceramics.
    if (buffer.getNumChannels() < wires + monitors)
    {
        buffer.clear();
        return;
    }

    for (int k = 0; k < wires; ++k)
        ceramics[static_cast<std::size_t> (k)] = buffer.getWritePointer (ceramicOrder[static_cast<std::size_t> (k)]);

    for (int i = 0; i < monitors; ++i)
        monitor[static_cast<std::size_t> (i)] = buffer.getWritePointer (firstMonitor + i);

    for (auto i = wires + monitors; i < buffer.getNumChannels(); ++i)
        buffer.clear (i, 0, buffer.getNumSamples());

    auto now = controls->controls();
    now.isArmed = now.isArmed && ! isBypassed;
    now.mutes = mutedCeramics;
    const OutputBlock<Sample> block { { ceramics.data(), static_cast<std::size_t> (wires) },
                                      { monitor.data(), static_cast<std::size_t> (monitors) },
                                      buffer.getNumSamples() };
    const auto events = triggers.read (midi, buffer.getNumSamples());

    if (isNonRealtime())
        player->waitUntilSettled (events);

    player->process (block, events, now);
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

void AntinodeProcessor::getStateInformation (juce::MemoryBlock& block)
{
    const auto text = stateToText (state());
    block.replaceAll (text.data(), text.size());
}

void AntinodeProcessor::setStateInformation (const void* data, int size)
{
    try
    {
        setState (readState ({ static_cast<const char*> (data), static_cast<std::size_t> (std::max (0, size)) }), true);
        setWarning ({});
    }
    catch (const InputError& failure)
    {
        setWarning ("The saved state could not be read, so nothing was changed: "
                    + juce::String::fromUTF8 (failure.what()));
    }
}

void AntinodeProcessor::tellOfChanges()
{
    const auto wanted = static_cast<int> (player->latencySamples());

    if (wanted != getLatencySamples())
        setLatencySamples (wanted);

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
