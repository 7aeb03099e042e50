#include "NumberParameter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
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
} // namespace antinode
