#include "PlateProcessor.h"

namespace antinode
{
std::function<juce::AudioProcessorEditor*(PlateProcessor&)> PlateProcessor::makeEditor;

PlateProcessor::PlateProcessor (int ceramics, WrapperType wrapper)
    : DeviceEffect ({ "Voltages", ceramics, maximumCeramics }, { "Probes", maximumProbes, maximumProbes },
                    SensorBus::none, wrapper, plateSchema, "staple")
{
    controls = std::make_unique<PlateParameters> (
        *this, [this] { return surface != nullptr ? surface->snapshot()->model : nullptr; });
    surface = std::make_unique<PlateSession> (
        *device(), [this] { return readSettings(); }, [this] { post(); });
    begin();
}

PlateProcessor::~PlateProcessor()
{
    end();
}

std::vector<UserMessage> PlateProcessor::ownMessages()
{
    const auto now = surface->snapshot();
    const auto channels = getChannelCountOfBus (true, 0);
    const auto ceramics = now->model != nullptr ? static_cast<int> (now->model->actuators()) : 0;
    std::vector<UserMessage> messages;
    addMessage (messages, Urgency::warning, now->error);

    if (surface->meters().isMutedForBadNumbers())
        addMessage (messages, Urgency::warning,
                    "A voltage was not a finite number: the surface gets 0 V until playback starts again.");

    if (ceramics > channels)
        addMessage (messages, Urgency::warning,
                    "The device has " + std::to_string (ceramics) + " ceramics, but the input has only "
                        + std::to_string (channels) + (channels == 1 ? " channel" : " channels") + ": ceramics "
                        + std::to_string (channels + 1) + " and up get 0 V.");

    return messages;
}

template <typename Sample>
void PlateProcessor::playSurface (const SurfaceBlock<Sample>& block, bool isBypassed)
{
    if (isNonRealtime())
        surface->waitUntilSettled();

    auto now = controls->controls();
    now.isPlaying = now.isPlaying && ! isBypassed;
    surface->process (block, now);
}

void PlateProcessor::playChannels (const EffectBlock<float>& block)
{
    playSurface<float> ({ block.in, block.out, block.count }, block.isBypassed);
}

void PlateProcessor::playChannels (const EffectBlock<double>& block)
{
    playSurface<double> ({ block.in, block.out, block.count }, block.isBypassed);
}

/** As in AntinodeProcessor: a host is told of a step as soon as the session has looked. */
SurfaceSettings PlateProcessor::readSettings()
{
    if (controls->stepReports().isWaiting())
        post();

    return controls->settings();
}
} // namespace antinode
