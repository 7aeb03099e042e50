#include "PlateProcessor.h"

#include "PlateContent.h"

#include <Processor/ParameterSet.h>
#include <Processor/ParameterTypes.h>

#include <cmath>
#include <tuple>
#include <utility>

namespace antinode
{
namespace
{
constexpr double silentDecibels = -60, loudestDecibels = 60;
constexpr float silentText = -60 + 1e-3F; // below which it is called silent

/** Where probes are at first, in % of the surface: in the middle, on its axes, then in its quarters. */
constexpr std::pair<double, double> firstPlaces[PlatePath::probes] = { { 50, 50 }, { 25, 50 }, { 75, 50 }, { 50, 25 },
                                                                       { 50, 75 }, { 25, 25 }, { 75, 75 }, { 25, 75 } };
} // namespace

PlateParameters::PlateParameters (juce::AudioProcessor& processor, const SurfaceSource& surface)
{
    GroupBuilder probes (processor, "probes", "Probes", ordered);

    for (int i = 0; i < PlatePath::probes; ++i)
    {
        const auto number = juce::String (i + 1);
        const auto [x, y] = firstPlaces[i];
        auto& place = places[static_cast<std::size_t> (i)];
        place.x = probes.number ("probe" + number + "_x", "Probe " + number + " x", "", { 0, 100 }, x,
                                 placeTexts (surface, SurfaceAxis::x));
        place.y = probes.number ("probe" + number + "_y", "Probe " + number + " y", "", { 0, 100 }, y,
                                 placeTexts (surface, SurfaceAxis::y));
    }

    probes.addToProcessor();
    GroupBuilder output (processor, "output", "Output", ordered);
    gain = output.number ("gain", "Gain", "", { silentDecibels, loudestDecibels }, 0,
                          unitTexts ("dB", 1, silentText, "silent"));
    quick = output.flag ("quick", "Surface model", false, "quick", "as rendered");
    bypassed = output.flag ("bypass", "Bypass", false, "bypassed", "playing");
    output.addToProcessor();
    begin();
}

SurfaceSettings PlateParameters::settings() const
{
    SurfaceSettings settings;

    for (std::size_t i = 0; i < places.size(); ++i)
        settings.probes[i] = { static_cast<float> (places[i].x->get()), static_cast<float> (places[i].y->get()) };

    settings.model = quick->get() ? SurfaceModel::quick : SurfaceModel::asRendered;
    return settings;
}

SurfaceControls PlateParameters::controls() const
{
    const auto decibels = gain->get();
    return { ! bypassed->get(), decibels <= silentDecibels ? 0.0 : std::pow (10, decibels / 20) };
}

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
