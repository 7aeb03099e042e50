#pragma once

#include "ParameterTexts.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <atomic>
#include <vector>

namespace antinode
{
/** A switch. What a host sets takes the nearer step at once, which juce::AudioParameterBool does not; what is no number
   changes nothing. */
class SwitchParameter : public juce::RangedAudioParameter
{
public:
    /** [message thread] */
    SwitchParameter (const juce::ParameterID&, const juce::String& name, bool initial, FlagTexts, bool isAutomatable);

    bool get() const { return value; }
    operator bool() const { return value; }

    /** Tells the host where it changes. [any but the audio thread] */
    SwitchParameter& operator= (bool);

    const juce::NormalisableRange<float>& getNormalisableRange() const override { return range; }
    int getNumSteps() const override { return 2; }
    bool isDiscrete() const override { return true; }
    bool isBoolean() const override { return true; }

private:
    float getValue() const override { return value ? 1.0F : 0.0F; }
    void setValue (float share) override;
    float getDefaultValue() const override { return defaultShare; }
    juce::String getText (float share, int maximumLength) const override;
    float getValueForText (const juce::String&) const override;

    const juce::NormalisableRange<float> range { 0, 1, 1 };
    const float defaultShare;
    std::atomic<bool> value;
    FlagTexts texts;
};

/** A whole number from 0 on, whose steps hosts are told of. LV2 hosts are not: JUCE's wrapper would name the steps at 0
   to 1 and not where they are. What is no number changes nothing. */
class IntegerParameter : public juce::RangedAudioParameter
{
public:
    /** [message thread] */
    IntegerParameter (const juce::ParameterID&, const juce::String& name, int maximum, IntegerTexts,
                      juce::AudioProcessor::WrapperType, int initial = 0);

    int get() const { return value; }

    const juce::NormalisableRange<float>& getNormalisableRange() const override { return range; }
    int getNumSteps() const override { return juce::roundToInt (range.end) + 1; }
    bool isDiscrete() const override { return tellsSteps; }

private:
    float getValue() const override { return convertTo0to1 (static_cast<float> (value)); }
    void setValue (float share) override;
    float getDefaultValue() const override { return convertTo0to1 (static_cast<float> (initialValue)); }
    juce::String getText (float share, int maximumLength) const override;
    float getValueForText (const juce::String&) const override;

    const juce::NormalisableRange<float> range;
    const bool tellsSteps;
    const int initialValue;
    std::atomic<int> value;
    IntegerTexts texts;
};

/** Whether a parameter has steps, told or not. [any] */
bool hasSteps (const juce::AudioProcessorParameter&);

/** Hosts keep what they have set. Where that lay between two steps of a parameter, this tells them which step it took.
    Docs/Design/plugins.md */
class StepReports : private juce::AudioProcessorParameter::Listener
{
public:
    /** @param parameters  those with steps are listened to; outlive this; belong to a processor already [message
        thread] */
    explicit StepReports (const std::vector<juce::RangedAudioParameter*>& parameters);
    ~StepReports() override;

    /** One more. [message thread] */
    void add (juce::RangedAudioParameter&);

    /** Whether there is something to tell. [any] */
    bool isWaiting() const { return waits; }

    /** Tells it. [message thread] */
    void tell();

private:
    struct Step
    {
        explicit Step (juce::RangedAudioParameter* stepped) : parameter (stepped) {}

        juce::RangedAudioParameter* parameter;
        std::atomic<bool> waits { false };
    };

    void parameterValueChanged (int index, float share) override;
    void parameterGestureChanged (int, bool) override {}

    std::vector<std::unique_ptr<Step>> steps;
    std::atomic<bool> waits { false };
};
} // namespace antinode
