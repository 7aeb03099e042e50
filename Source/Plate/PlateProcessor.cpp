#include "PlateProcessor.h"

#include "PlateContent.h"

#include <utility>

namespace antinode
{
PlateProcessor::PlateProcessor (int ceramics, WrapperType wrapper)
    : DeviceProcessor ({ Bus { "Voltages", ceramics }, { "Probes", maximumProbes, maximumProbes } }, wrapper,
                       SessionRole::plate, deviceDocument ("staple"))
{
    controls = std::make_unique<PlateParameters> (
        *this, [this] { return surface != nullptr ? session().snapshot()->model : nullptr; });
    surface = std::make_unique<SessionThread<PlateSession>> (
        *device(),
        [this]
        {
            reportSteps();
            return controls->settings();
        },
        [this] { post(); });
    begin();
}

PlateProcessor::~PlateProcessor()
{
    end();
}

void PlateProcessor::load (std::shared_ptr<const DeviceDocument> device)
{
    keep (device);
    session().load (std::move (device));
}

void PlateProcessor::setState (const SessionState& wanted, bool)
{
    controls->setValues (wanted.parameters);

    if (wanted.device->text != device()->text)
        load (wanted.device);
}

DeviceProcessor::Playing PlateProcessor::playing() const
{
    const auto now = session().snapshot();
    return { now->model, now->error, session().meters().isMutedForBadNumbers(), session().latencySamples() };
}

template <typename Sample>
void PlateProcessor::playSurface (const AudioBlock<Sample>& block, bool isBypassed)
{
    auto now = controls->controls();
    now.isPlaying = now.isPlaying && ! isBypassed;
    session().process (block, now);
}

void PlateProcessor::playBlock (const AudioBlock<float>& block, bool isBypassed)
{
    playSurface (block, isBypassed);
}

void PlateProcessor::playBlock (const AudioBlock<double>& block, bool isBypassed)
{
    playSurface (block, isBypassed);
}

juce::AudioProcessorEditor* PlateProcessor::createEditor()
{
    return editorAsLeft<PlateContent> (*this).release();
}
} // namespace antinode
