#include "StepParameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
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
