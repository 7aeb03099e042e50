#pragma once

#include <antinode_model/ModalModel.h>
#include <juce_audio_processors/juce_audio_processors.h>
#include <juce_core/juce_core.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace antinode
{
/** A parameter's value as text, and back: fromText reads what toText returns, and what a person types (typedNumber);
   none where that says nothing. */
struct NumberTexts
{
    std::function<juce::String (float value, int maximumLength)> toText;
    std::function<std::optional<float> (const juce::String&)> fromText;
};

struct IntegerTexts
{
    std::function<juce::String (int value, int maximumLength)> toText;
    std::function<std::optional<int> (const juce::String&)> fromText;
    std::vector<int> retired = {}; ///< Values that hosts and states may still have, and that no window offers.
};

struct FlagTexts
{
    std::function<juce::String (bool value, int maximumLength)> toText;
    std::function<std::optional<bool> (const juce::String&)> fromText;
};

/** Which coordinate of a place on the surface. */
enum class SurfaceAxis
{
    x,
    y
};

/** A number with its unit. Values below `least` have a word instead. [any] */
NumberTexts unitTexts (const char* unit, int decimals, float minimum = -1e30F, const char* wordBelow = "");

/** A share of the surface in percent, as a place in mm: of the model that is played, or in percent if there is none.
    A text that ends in % is read as percent. [any but the audio thread] */
NumberTexts placeTexts (const std::function<std::shared_ptr<const ModalModel>()>& model, SurfaceAxis);

/** A count, with a word for 0. [any] */
IntegerTexts countTexts (const char* wordForNone);

/** Words, the first one for 0. [any] */
IntegerTexts wordTexts (const std::vector<juce::String>& words, std::vector<int> retired = {});

/** [any] */
FlagTexts flagTexts (const char* on, const char* off);

/** The values of a continuous parameter, and which share of the range each is. */
struct ParameterRange
{
    double minimum = 0, maximum = 1;
    bool isLogarithmic = false;

    /** [any] @param share  0 to 1 */
    double valueAt (double share) const;

    /** [any] */
    double normalisedValue (double value) const;
};

/** A continuous parameter. It keeps its value in double precision: so both the share that a host sets and the value
   that a state keeps are given back to the bit, which juce::AudioParameterFloat does with neither.
   Docs/Design/plugins.md */
class NumberParameter : public juce::RangedAudioParameter
{
public:
    /** @param initial  becomes what a host can set [message thread] */
    NumberParameter (const juce::ParameterID&, const juce::String& name, ParameterRange, double initial, NumberTexts,
                     const juce::String& unit);

    /** Within the range. [any] */
    double get() const { return value; }

    /** Sets a value to the bit, one beyond the range to its end, one that is not finite not at all; tells the host
       where it changes. [any but the audio thread] */
    NumberParameter& operator= (double);

    const juce::NormalisableRange<float>& getNormalisableRange() const override { return floatRange; }

private:
    float getValue() const override { return static_cast<float> (range.normalisedValue (value)); }
    void setValue (float share) override;
    float getDefaultValue() const override { return defaultShare; }
    juce::String getText (float share, int maximumLength) const override;
    float getValueForText (const juce::String&) const override;

    ParameterRange range;
    juce::NormalisableRange<float> floatRange;
    float defaultShare;
    std::atomic<double> value;
    NumberTexts texts;
};

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

    /** Whether windows offer a value. [any] */
    bool offers (int) const;

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
