#include "ParameterValues.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** The share that gives a value back to the bit where one does: a state must not change by being kept. The range's own inverse is
    off by some last digits. */
float shareOf (const juce::RangedAudioParameter& parameter, float value)
{
    constexpr float inaccuracy = 1e-6F;
    constexpr int halvings = 32;
    auto share = parameter.convertTo0to1 (value);
    auto low = std::max (0.0F, share - inaccuracy), high = std::min (1.0F, share + inaccuracy);

    for (int i = 0; i < halvings && parameter.convertFrom0to1 (share) != value; ++i)
    {
        (parameter.convertFrom0to1 (share) < value ? low : high) = share;
        share = low + (high - low) / 2;
    }

    return share;
}
} // namespace

float numberOf (const juce::AudioParameterFloat* parameter)
{
    const auto value = parameter->get();
    return std::isnan (value) ? parameter->range.start : value;
}

int integerOf (const juce::AudioParameterInt* parameter)
{
    const auto range = parameter->getRange();
    return std::clamp (parameter->get(), range.getStart(), range.getEnd());
}

double valueOf (const juce::RangedAudioParameter& parameter)
{
    // What getValue() gives has been through the range and back.
    if (const auto* const number = dynamic_cast<const juce::AudioParameterFloat*> (&parameter))
        return static_cast<double> (numberOf (number));

    const auto value = parameter.convertFrom0to1 (parameter.getValue());
    return static_cast<double> (std::isnan (value) ? parameter.getNormalisableRange().start : value);
}

void setValue (juce::RangedAudioParameter& parameter, double value)
{
    const auto range = parameter.getNormalisableRange();
    const auto allowed = std::clamp (static_cast<float> (value), range.start, range.end);

    if (static_cast<double> (allowed) != valueOf (parameter))
        parameter.setValueNotifyingHost (shareOf (parameter, allowed));
}
} // namespace antinode
