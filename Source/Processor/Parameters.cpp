#include "Parameters.h"

#include "ParameterTexts.h"
#include "ParameterValues.h"

#include <antinode_documents/FocusWords.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace antinode
{
namespace
{
using Group = juce::AudioProcessorParameterGroup;

constexpr float silentDecibels = -60;

/** In double precision: then a share that became a value becomes the same share again, and states come back to the letter. */
juce::NormalisableRange<float> logarithmic (float minimum, float maximum)
{
    const auto valueAt = [] (double low, double high, double share) { return low * std::pow (high / low, share); };
    const auto shareOf = [] (double low, double high, double value)
    { return std::log (value / low) / std::log (high / low); };

    return { minimum, maximum,
             [=] (float low, float high, float share)
             {
                 return static_cast<float> (
                     valueAt (static_cast<double> (low), static_cast<double> (high), static_cast<double> (share)));
             },
             [=] (float low, float high, float value)
             {
                 return static_cast<float> (
                     shareOf (static_cast<double> (low), static_cast<double> (high), static_cast<double> (value)));
             } };
}

/** Adds parameters to a group and keeps a plain pointer to each. */
class GroupBuilder
{
public:
    GroupBuilder (const juce::String& identifier, const juce::String& name,
                  std::vector<juce::RangedAudioParameter*>& list)
        : group (std::make_unique<Group> (identifier, name, " | ")), all (list)
    {
    }

    juce::AudioParameterFloat* number (const char* identifier, const char* name, const char* unit,
                                       juce::NormalisableRange<float> range, float initial, NumberTexts texts)
    {
        auto attributes = juce::AudioParameterFloatAttributes()
                              .withLabel (juce::String::fromUTF8 (unit))
                              .withStringFromValueFunction (std::move (texts.toText))
                              .withValueFromStringFunction (std::move (texts.fromText));
        // As a host would set it, so that a host can set it again to the bit.
        const auto reachable = range.convertFrom0to1 (range.convertTo0to1 (initial));
        return add (std::make_unique<juce::AudioParameterFloat> (juce::ParameterID { identifier, 1 }, name,
                                                                 std::move (range), reachable, attributes));
    }

    juce::AudioParameterInt* integer (const char* identifier, const char* name, int maximum, IntegerTexts texts)
    {
        auto attributes = juce::AudioParameterIntAttributes()
                              .withStringFromValueFunction (std::move (texts.toText))
                              .withValueFromStringFunction (std::move (texts.fromText));
        return add (std::make_unique<juce::AudioParameterInt> (juce::ParameterID { identifier, 1 }, name, 0, maximum, 0,
                                                               attributes));
    }

    /** A choice of words: an integer, since JUCE's LV2 wrapper gives choices wrong scale points. */
    juce::AudioParameterInt* choice (const char* identifier, const char* name, const std::vector<juce::String>& words)
    {
        const auto maximum = static_cast<int> (words.size()) - 1;
        return integer (identifier, name, maximum, wordTexts (words));
    }

    juce::AudioParameterBool* flag (const char* identifier, const char* name, bool initial, const char* on,
                                    const char* off)
    {
        auto texts = flagTexts (on, off);
        auto attributes = juce::AudioParameterBoolAttributes()
                              .withStringFromValueFunction (std::move (texts.toText))
                              .withValueFromStringFunction (std::move (texts.fromText));
        return add (std::make_unique<juce::AudioParameterBool> (juce::ParameterID { identifier, 1 }, name, initial,
                                                                attributes));
    }

    void addTo (juce::AudioProcessor& processor) { processor.addParameterGroup (std::move (group)); }

private:
    template <typename Parameter>
    Parameter* add (std::unique_ptr<Parameter> parameter)
    {
        auto* const plain = parameter.get();
        group->addChild (std::move (parameter));
        all.push_back (plain);
        return plain;
    }

    std::unique_ptr<Group> group;
    std::vector<juce::RangedAudioParameter*>& all;
};

template <typename Words>
std::vector<juce::String> wordsForHosts (const Words& words)
{
    std::vector<juce::String> texts;
    texts.reserve (std::size (words));

    for (const auto& [word, value] : words)
        texts.push_back (juce::String (std::string (word)).replaceCharacter ('_', ' '));

    return texts;
}
} // namespace

Parameters::Parameters (juce::AudioProcessor& processor,
                        const std::function<std::shared_ptr<const ModalModel>()>& model)
{
    GroupBuilder focus ("focus", "Focus", ordered);
    x = focus.number ("x", "Focus x", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::x));
    y = focus.number ("y", "Focus y", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::y));
    width = focus.number ("width", "Width", "mm", logarithmic (1, 200), 25, unitTexts ("mm", 2));
    shape = focus.choice ("shape", "Shape", wordsForHosts (targetShapeWords));
    peakVelocity =
        focus.number ("peak_velocity", "Peak velocity", "mm/s", logarithmic (0.1F, 2000), 40, unitTexts ("mm/s", 2));
    focusTime = focus.number ("focus_time", "Focus time", "ms", logarithmic (1, 500), 25, unitTexts ("ms", 2));
    focus.addTo (processor);

    GroupBuilder drive ("drive", "Drive", ordered);
    growth = drive.number ("growth", "Growth", "", { -1, 50 }, -1, unitTexts ("", 2, 0, "chosen"));
    brake = drive.number ("brake", "Brake", "", { 0, 50 }, 0, unitTexts ("", 2, 1.0F + 1e-6F, "as the focus says"));
    method = drive.choice ("method", "Allocation", wordsForHosts (allocationMethodWords));
    voltageLimit = drive.number ("voltage_limit", "Voltage limit", "V", { 0, 500 }, 0,
                                 unitTexts ("V", 1, 1e-6F, "as the focus says"));
    modes = drive.integer ("modes", "Controlled modes", 512, countTexts ("chosen"));
    drive.addTo (processor);

    GroupBuilder triggers ("triggers", "Triggers", ordered);
    notes = triggers.choice ("notes", "Notes play", { "places over the surface", "the focus alone" });
    noteOff = triggers.choice ("note_off", "Note off", { "is ignored", "fades out", "brakes" });
    retrigger = triggers.choice ("retrigger", "Retrigger", { "overlaps", "restarts" });
    focusOnNote = triggers.flag ("focus_on_note", "Focus on the note", false, "focus on the note", "start on the note");
    triggers.addTo (processor);

    GroupBuilder monitor ("monitor", "Monitor", ordered);
    probeX = monitor.number ("probe_x", "Probe x", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::x));
    probeY = monitor.number ("probe_y", "Probe y", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::y));
    monitorGain = monitor.number ("monitor_gain", "Monitor gain", "dB", { silentDecibels, 60 }, 0,
                                  unitTexts ("dB", 1, silentDecibels + 1e-3F, "silent"));
    monitor.addTo (processor);

    GroupBuilder output ("output", "Output", ordered);
    outputTrim = output.number ("output_trim", "Output trim", "dB", { silentDecibels, 0 }, 0,
                                unitTexts ("dB", 1, silentDecibels + 1e-3F, "silent"));
    armed = output.flag ("arm", "Arm", true, "armed", "disarmed");
    bypassed = output.flag ("bypass", "Bypass", false, "bypassed", "playing");
    output.addTo (processor);
}

PlaySettings Parameters::settings() const
{
    PlaySettings now;
    now.xPercent = numberOf (x);
    now.yPercent = numberOf (y);
    now.widthMillimetres = numberOf (width);
    now.shape = integerOf (shape);
    now.peakVelocityMillimetresPerSecond = numberOf (peakVelocity);
    now.focusTimeMilliseconds = numberOf (focusTime);
    now.growth = numberOf (growth);
    now.brake = numberOf (brake);
    now.method = integerOf (method);
    now.voltageLimitVolts = numberOf (voltageLimit);
    now.modeCount = integerOf (modes);
    now.probeXPercent = numberOf (probeX);
    now.probeYPercent = numberOf (probeY);
    now.noteLayout = integerOf (notes);
    now.noteOff = integerOf (noteOff);
    now.retrigger = integerOf (retrigger);
    now.focusOnNote = *focusOnNote;
    return now;
}

PlayControls Parameters::controls() const
{
    const auto gain = [] (float decibels)
    { return static_cast<double> (juce::Decibels::decibelsToGain (decibels, silentDecibels)); };

    PlayControls now;
    now.isArmed = *armed && ! *bypassed;
    now.outputTrim = gain (numberOf (outputTrim));
    now.monitorGain = gain (numberOf (monitorGain));

    if (const auto limit = numberOf (voltageLimit); limit > 0)
        now.voltageLimit = static_cast<double> (limit);

    return now;
}

void Parameters::setFocus (const PlaySettings& settings)
{
    const std::pair<juce::RangedAudioParameter*, float> wanted[] = {
        { x, settings.xPercent },
        { y, settings.yPercent },
        { width, settings.widthMillimetres },
        { shape, static_cast<float> (settings.shape) },
        { peakVelocity, settings.peakVelocityMillimetresPerSecond },
        { focusTime, settings.focusTimeMilliseconds },
        { growth, settings.growth },
        { brake, settings.brake },
        { method, static_cast<float> (settings.method) },
        { voltageLimit, settings.voltageLimitVolts },
        { modes, static_cast<float> (settings.modeCount) },
        { probeX, settings.probeXPercent },
        { probeY, settings.probeYPercent },
    };

    for (const auto& [parameter, value] : wanted)
        setValue (*parameter, static_cast<double> (value));
}

std::map<std::string, double> Parameters::values() const
{
    std::map<std::string, double> named;

    for (const auto* const parameter : ordered)
        named[parameter->getParameterID().toStdString()] = valueOf (*parameter);

    return named;
}

void Parameters::setValues (const std::map<std::string, double>& named)
{
    for (auto* const parameter : ordered)
    {
        const auto found = named.find (parameter->getParameterID().toStdString());
        const auto initial = static_cast<double> (parameter->convertFrom0to1 (parameter->getDefaultValue()));
        setValue (*parameter, found == named.end() ? initial : found->second);
    }
}

juce::RangedAudioParameter* Parameters::find (const std::string& identifier) const
{
    const auto found =
        std::find_if (ordered.begin(), ordered.end(),
                      [&] (const auto* parameter) { return parameter->getParameterID() == juce::String (identifier); });
    return found == ordered.end() ? nullptr : *found;
}
} // namespace antinode
