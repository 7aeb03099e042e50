#pragma once

#include "ParameterTexts.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <atomic>

namespace antinode
{
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
} // namespace antinode
