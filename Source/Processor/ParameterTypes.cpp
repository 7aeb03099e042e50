#include "ParameterTypes.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double milli = 1e-3;

juce::String cut (const juce::String& text, int maximumLength)
{
    return maximumLength > 0 ? text.substring (0, maximumLength) : text;
}

/** Enough decimals that small numbers keep their digits, none that say nothing. */
juce::String numberText (double value, int decimals)
{
    auto text = juce::String (value, decimals);
    return text.containsChar ('.') ? text.trimCharactersAtEnd ("0").trimCharactersAtEnd (".") : text;
}

std::optional<double> numberIn (const juce::String& text, std::initializer_list<std::string_view> units)
{
    return typedNumber (text.toStdString(), units);
}

std::optional<int> wholeNumberIn (const juce::String& text)
{
    constexpr double most = 1e9;
    const auto number = numberIn (text, {});
    return number && *number == std::round (*number) && std::abs (*number) <= most
               ? std::optional (static_cast<int> (*number))
               : std::nullopt;
}

/** From where to where the surface goes, mm; both 0 if there is none. */
std::pair<double, double> axisExtent (const ModalModel* model, SurfaceAxis axis)
{
    if (model == nullptr)
        return { 0, 0 };

    const auto& surface = model->surface;
    return axis == SurfaceAxis::x ? std::pair (surface.xMinimum / milli, surface.xMaximum / milli)
                                  : std::pair (surface.yMinimum / milli, surface.yMaximum / milli);
}
} // namespace

NumberTexts unitTexts (const char* unit, int decimals, float minimum, const char* wordBelow)
{
    const juce::String word (wordBelow), suffix (juce::String::fromUTF8 (unit));

    return { [=] (float value, int maximumLength)
             {
                 if (value < minimum && word.isNotEmpty())
                     return cut (word, maximumLength);

                 const auto number = numberText (static_cast<double> (value), decimals);
                 return cut (suffix.isEmpty() ? number : number + " " + suffix, maximumLength);
             },
             [=] (const juce::String& text) -> std::optional<float>
             {
                 if (word.isNotEmpty() && text.trim().equalsIgnoreCase (word))
                     return -1e9F;

                 return numberIn (text, { unit });
             } };
}

NumberTexts placeTexts (const std::function<std::shared_ptr<const ModalModel>()>& model, SurfaceAxis axis)
{
    return { [=] (float percent, int maximumLength)
             {
                 const auto [from, to] = axisExtent (model().get(), axis);
                 const auto millimetres = from + (to - from) * static_cast<double> (percent) / 100;
                 return cut (to > from ? numberText (millimetres, 3) + " mm"
                                       : numberText (static_cast<double> (percent), 3) + " %",
                             maximumLength);
             },
             [=] (const juce::String& text) -> std::optional<float>
             {
                 const auto [from, to] = axisExtent (model().get(), axis);
                 const auto isPercent = text.containsChar ('%') || ! (to > from);
                 const auto value = numberIn (text, { isPercent ? "%" : "mm" });

                 if (! value)
                     return {};

                 return static_cast<float> (
                     std::clamp (isPercent ? *value : 100 * (*value - from) / (to - from), 0.0, 100.0));
             } };
}

IntegerTexts countTexts (const char* wordForNone)
{
    const juce::String word (wordForNone);
    return { [=] (int value, int maximumLength)
             { return cut (value == 0 ? word : juce::String (value), maximumLength); },
             [=] (const juce::String& text) -> std::optional<int>
             { return text.trim().equalsIgnoreCase (word) ? 0 : wholeNumberIn (text); } };
}

IntegerTexts wordTexts (const std::vector<juce::String>& words, std::vector<int> retired)
{
    return { [=] (int value, int maximumLength)
             {
                 const auto index = std::clamp (value, 0, static_cast<int> (words.size()) - 1);
                 return cut (words[static_cast<std::size_t> (index)], maximumLength);
             },
             [=] (const juce::String& text) -> std::optional<int>
             {
                 const auto found =
                     std::find_if (words.begin(), words.end(),
                                   [&] (const auto& word) { return word.equalsIgnoreCase (text.trim()); });
                 return found == words.end() ? wholeNumberIn (text) : static_cast<int> (found - words.begin());
             },
             std::move (retired) };
}

FlagTexts flagTexts (const char* on, const char* off)
{
    const juce::String yes (on), no (off);
    return { [=] (bool value, int maximumLength) { return cut (value ? yes : no, maximumLength); },
             [=] (const juce::String& text) -> std::optional<bool>
             {
                 const auto trimmed = text.trim();
                 const auto isOneOf = [&] (std::initializer_list<juce::String> words)
                 {
                     return std::any_of (words.begin(), words.end(),
                                         [&] (const auto& word) { return trimmed.equalsIgnoreCase (word); });
                 };

                 if (isOneOf ({ yes, "on", "yes", "true" }))
                     return true;

                 if (isOneOf ({ no, "off", "no", "false" }))
                     return false;

                 const auto number = numberIn (text, {});
                 return number ? std::optional (*number >= 0.5) : std::nullopt;
             } };
}

namespace
{
juce::NormalisableRange<float> inFloats (ParameterRange range)
{
    return { static_cast<float> (range.minimum), static_cast<float> (range.maximum),
             [range] (float, float, float share)
             { return static_cast<float> (range.valueAt (static_cast<double> (share))); },
             [range] (float, float, float value)
             { return static_cast<float> (range.normalisedValue (static_cast<double> (value))); } };
}
} // namespace

double ParameterRange::valueAt (double share) const
{
    const auto between =
        isLogarithmic ? minimum * std::pow (maximum / minimum, share) : minimum + (maximum - minimum) * share;
    return std::clamp (between, minimum, maximum);
}

double ParameterRange::normalisedValue (double value) const
{
    const auto share = isLogarithmic ? std::log (value / minimum) / std::log (maximum / minimum)
                                     : (value - minimum) / (maximum - minimum);
    return std::clamp (share, 0.0, 1.0);
}

NumberParameter::NumberParameter (const juce::ParameterID& identifier, const juce::String& name,
                                  ParameterRange rangeToUse, double initial, NumberTexts textsToUse,
                                  const juce::String& unit)
    : RangedAudioParameter (identifier, name, juce::AudioProcessorParameterWithIDAttributes().withLabel (unit)),
      range (rangeToUse), floatRange (inFloats (range)),
      defaultShare (static_cast<float> (range.normalisedValue (initial))),
      value (range.valueAt (static_cast<double> (defaultShare))), texts (std::move (textsToUse))
{
}

NumberParameter& NumberParameter::operator= (double wanted)
{
    if (! std::isfinite (wanted))
        return *this;

    const auto allowed = std::clamp (wanted, range.minimum, range.maximum);

    if (value.exchange (allowed) != allowed)
        sendValueChangedMessageToListeners (getValue());

    return *this;
}

/** A share that is set again leaves the value as it is: hosts send back what they were told. So does one that is no
   number. */
void NumberParameter::setValue (float share)
{
    if (std::isfinite (share) && share != getValue())
        value = range.valueAt (static_cast<double> (share));
}

juce::String NumberParameter::getText (float share, int maximumLength) const
{
    return texts.toText (convertFrom0to1 (share), maximumLength);
}

float NumberParameter::getValueForText (const juce::String& text) const
{
    const auto typed = texts.fromText (text);
    return typed ? convertTo0to1 (*typed) : getValue();
}

namespace
{
juce::NormalisableRange<float> steps (int maximum)
{
    juce::NormalisableRange<float> range {
        0, static_cast<float> (maximum), [] (float, float end, float share) { return share * end; },
        [] (float, float end, float value) { return value / end; },
        [] (float start, float end, float value)
        { return static_cast<float> (juce::roundToInt (std::clamp (value, start, end))); }
    };
    range.interval = 1;
    return range;
}
} // namespace

SwitchParameter::SwitchParameter (const juce::ParameterID& identifier, const juce::String& name, bool initial,
                                  FlagTexts textsToUse, bool isAutomatable)
    : RangedAudioParameter (identifier, name,
                            juce::AudioProcessorParameterWithIDAttributes().withAutomatable (isAutomatable)),
      defaultShare (initial ? 1.0F : 0.0F), value (initial), texts (std::move (textsToUse))
{
}

SwitchParameter& SwitchParameter::operator= (bool wanted)
{
    if (wanted != value)
        setValueNotifyingHost (wanted ? 1.0F : 0.0F);

    return *this;
}

void SwitchParameter::setValue (float share)
{
    if (std::isfinite (share))
        value = share >= 0.5F;
}

juce::String SwitchParameter::getText (float share, int maximumLength) const
{
    return texts.toText (share >= 0.5F, maximumLength);
}

float SwitchParameter::getValueForText (const juce::String& text) const
{
    return texts.fromText (text).value_or (value) ? 1.0F : 0.0F;
}

IntegerParameter::IntegerParameter (const juce::ParameterID& identifier, const juce::String& name, int maximum,
                                    IntegerTexts textsToUse, juce::AudioProcessor::WrapperType wrapper, int initial)
    : RangedAudioParameter (identifier, name), range (steps (maximum)),
      tellsSteps (wrapper != juce::AudioProcessor::wrapperType_LV2), initialValue (initial), value (initial),
      texts (std::move (textsToUse))
{
}

bool IntegerParameter::offers (int wanted) const
{
    return std::find (texts.retired.begin(), texts.retired.end(), wanted) == texts.retired.end();
}

void IntegerParameter::setValue (float share)
{
    if (std::isfinite (share))
        value = juce::roundToInt (convertFrom0to1 (share));
}

juce::String IntegerParameter::getText (float share, int maximumLength) const
{
    return texts.toText (juce::roundToInt (convertFrom0to1 (share)), maximumLength);
}

float IntegerParameter::getValueForText (const juce::String& text) const
{
    return convertTo0to1 (static_cast<float> (texts.fromText (text).value_or (value)));
}

bool hasSteps (const juce::AudioProcessorParameter& parameter)
{
    return parameter.getNumSteps() < juce::AudioProcessor::getDefaultNumParameterSteps();
}

StepReports::StepReports (const std::vector<juce::RangedAudioParameter*>& parameters)
{
    for (auto* const parameter : parameters)
        if (hasSteps (*parameter))
            add (*parameter);
}

StepReports::~StepReports()
{
    for (const auto& step : steps)
        step->parameter->removeListener (this);
}

void StepReports::add (juce::RangedAudioParameter& parameter)
{
    steps.push_back (std::make_unique<Step> (&parameter));
    parameter.addListener (this);
}

void StepReports::tell()
{
    waits = false;

    for (const auto& step : steps)
        if (step->waits.exchange (false))
        {
            auto& parameter = static_cast<juce::AudioProcessorParameter&> (*step->parameter);
            parameter.sendValueChangedMessageToListeners (parameter.getValue());
        }
}

/** A host may call this on the audio thread. */
void StepReports::parameterValueChanged (int index, float share)
{
    for (const auto& step : steps)
    {
        const auto& parameter = static_cast<const juce::AudioProcessorParameter&> (*step->parameter);

        if (parameter.getParameterIndex() == index && parameter.getValue() != share)
            step->waits = waits = true;
    }
}
} // namespace antinode
