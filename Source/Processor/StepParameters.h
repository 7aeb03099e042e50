#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <atomic>
#include <vector>

namespace antinode
{
/** A switch that takes the step nearest to what a host sets, at once: juce::AudioParameterBool reads back what lies
    between. */
class SwitchParameter : public juce::AudioParameterBool
{
public:
    using AudioParameterBool::AudioParameterBool;

private:
    float getValue() const override { return get() ? 1.0F : 0.0F; }
};

/** An integer whose steps hosts are told of, which juce::AudioParameterInt does not do. LV2 hosts are not: JUCE's
   wrapper would name the steps at 0 to 1 and not where they are. */
class IntegerParameter : public juce::AudioParameterInt
{
public:
    /** [message thread] */
    IntegerParameter (const juce::ParameterID&, const juce::String& name, int maximum,
                      const juce::AudioParameterIntAttributes&, juce::AudioProcessor::WrapperType, int initial = 0);

    bool isDiscrete() const override { return tellsSteps; }

private:
    const bool tellsSteps;
};

/** Whether a parameter has steps, told or not. [any] */
bool hasSteps (const juce::AudioProcessorParameter&);

/** Hosts keep what they have set. Where that lay between two steps of a parameter, this tells them which step it took.
    Docs/Decisions/0044-read-back.md */
class StepReports : private juce::AudioProcessorParameter::Listener
{
public:
    /** @param parameters  those with steps are listened to; outlive this; belong to a processor already [message
        thread] */
    explicit StepReports (const std::vector<juce::RangedAudioParameter*>& parameters);
    ~StepReports() override;

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
