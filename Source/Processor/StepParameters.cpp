#include "StepParameters.h"

namespace antinode
{
IntegerParameter::IntegerParameter (const juce::ParameterID& identifier, const juce::String& name, int maximum,
                                    const juce::AudioParameterIntAttributes& attributes,
                                    juce::AudioProcessor::WrapperType wrapper, int initial)
    : AudioParameterInt (identifier, name, 0, maximum, initial, attributes),
      tellsSteps (wrapper != juce::AudioProcessor::wrapperType_LV2)
{
}

bool hasSteps (const juce::AudioProcessorParameter& parameter)
{
    return parameter.getNumSteps() < juce::AudioProcessor::getDefaultNumParameterSteps();
}

StepReports::StepReports (const std::vector<juce::RangedAudioParameter*>& parameters)
{
    for (auto* const parameter : parameters)
        if (hasSteps (*parameter))
        {
            steps.push_back (std::make_unique<Step> (parameter));
            parameter->addListener (this);
        }
}

StepReports::~StepReports()
{
    for (const auto& step : steps)
        step->parameter->removeListener (this);
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
