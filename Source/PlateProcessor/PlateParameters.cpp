#include "PlateParameters.h"

#include <Processor/ParameterTexts.h>
#include <Processor/ParameterValues.h>

#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
using Group = juce::AudioProcessorParameterGroup;
using ModelSource = std::function<std::shared_ptr<const ModalModel>()>;

constexpr double silentDecibels = -60, loudestDecibels = 60;
constexpr float silentText = -60 + 1e-3F; // below which it is called silent

/** Where probes are at first, in % of the surface: in the middle, on its axes, then in its quarters. */
constexpr std::pair<double, double> firstPlaces[PlatePath::probes] = { { 50, 50 }, { 25, 50 }, { 75, 50 }, { 50, 25 },
                                                                       { 50, 75 }, { 25, 25 }, { 75, 75 }, { 25, 75 } };

std::unique_ptr<NumberParameter> numberFor (const juce::String& identifier, const juce::String& name,
                                            ParameterRange range, double initial, NumberTexts texts)
{
    return std::make_unique<NumberParameter> (juce::ParameterID { identifier, 1 }, name, range, initial,
                                              std::move (texts), "");
}

std::unique_ptr<SwitchParameter> flagFor (const juce::String& identifier, const juce::String& name, const char* on,
                                          const char* off)
{
    auto texts = flagTexts (on, off);
    auto attributes = juce::AudioParameterBoolAttributes()
                          .withStringFromValueFunction (std::move (texts.toText))
                          .withValueFromStringFunction (std::move (texts.fromText));
    return std::make_unique<SwitchParameter> (juce::ParameterID { identifier, 1 }, name, false, attributes);
}

template <typename Parameter>
Parameter* addTo (Group& group, std::vector<juce::RangedAudioParameter*>& all, std::unique_ptr<Parameter> parameter)
{
    auto* const plain = parameter.get();
    group.addChild (std::move (parameter));
    all.push_back (plain);
    return plain;
}
} // namespace

PlateParameters::PlateParameters (juce::AudioProcessor& processor, const ModelSource& surface)
{
    auto probes = std::make_unique<Group> ("probes", "Probes", " | ");

    for (int i = 0; i < PlatePath::probes; ++i)
    {
        const auto number = juce::String (i + 1);
        const auto [x, y] = firstPlaces[i];
        auto& place = places[static_cast<std::size_t> (i)];
        place.x = addTo (*probes, ordered,
                         numberFor ("probe" + number + "_x", "Probe " + number + " x", { 0, 100 }, x,
                                    placeTexts (surface, SurfaceAxis::x)));
        place.y = addTo (*probes, ordered,
                         numberFor ("probe" + number + "_y", "Probe " + number + " y", { 0, 100 }, y,
                                    placeTexts (surface, SurfaceAxis::y)));
    }

    auto output = std::make_unique<Group> ("output", "Output", " | ");
    gain = addTo (
        *output, ordered,
        numberFor ("gain", "Gain", { silentDecibels, loudestDecibels }, 0, unitTexts ("dB", 1, silentText, "silent")));
    quick = addTo (*output, ordered, flagFor ("quick", "Surface model", "quick", "as rendered"));
    bypassed = addTo (*output, ordered, flagFor ("bypass", "Bypass", "bypassed", "playing"));
    processor.addParameterGroup (std::move (probes));
    processor.addParameterGroup (std::move (output));
    steps = std::make_unique<StepReports> (ordered);
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

std::map<std::string, double> PlateParameters::values() const
{
    std::map<std::string, double> values;

    for (const auto* const parameter : ordered)
        values[parameter->getParameterID().toStdString()] = parameterValue (*parameter);

    return values;
}

void PlateParameters::setValues (const std::map<std::string, double>& values)
{
    for (auto* const parameter : ordered)
    {
        const auto found = values.find (parameter->getParameterID().toStdString());
        const auto initial = static_cast<double> (parameter->convertFrom0to1 (parameter->getDefaultValue()));
        setValue (*parameter, found != values.end() ? found->second : initial);
    }
}
} // namespace antinode
