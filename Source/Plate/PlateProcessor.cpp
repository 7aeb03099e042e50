#include "PlateProcessor.h"

#include "PlateContent.h"

#include <tuple>
#include <utility>

namespace antinode
{
PlateProcessor::PlateProcessor (int ceramics, WrapperType wrapper)
    : RoleProcessor ({ Bus { "Voltages", ceramics }, { "Probes", maximumProbes, maximumProbes } }, wrapper,
                     SessionRole::plate, deviceDocument ("staple"))
{
    start (std::tuple { *device() });
}

PlateProcessor::~PlateProcessor()
{
    close();
}

void PlateProcessor::load (std::shared_ptr<const DeviceDocument> device)
{
    keep (device);
    session().load (std::move (device));
}

void PlateProcessor::setState (const SessionState& wanted, bool)
{
    parameters().setValues (wanted.parameters);

    if (wanted.device->text != device()->text)
        load (wanted.device);
}

DeviceProcessor::Playing PlateProcessor::playing() const
{
    const auto now = session().snapshot();
    return { now->model, now->error, session().latencySamples(), &session().meters() };
}

juce::AudioProcessorEditor* PlateProcessor::createEditor()
{
    return editorAsLeft<PlateContent> (*this).release();
}
} // namespace antinode
