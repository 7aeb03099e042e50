#include "ParameterValues.h"

#include "NumberParameter.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
int integerValue (const juce::AudioParameterInt* parameter)
{
    const auto range = parameter->getRange();
    return std::clamp (parameter->get(), range.getStart(), range.getEnd());
}

double parameterValue (const juce::RangedAudioParameter& parameter)
{
    if (const auto* const number = dynamic_cast<const NumberParameter*> (&parameter))
        return number->get();

    const auto value = parameter.convertFrom0to1 (parameter.getValue());
    return static_cast<double> (std::isnan (value) ? parameter.getNormalisableRange().start : value);
}

void setValue (juce::RangedAudioParameter& parameter, double value)
{
    if (auto* const number = dynamic_cast<NumberParameter*> (&parameter))
    {
        *number = value;
        return;
    }

    const auto range = parameter.getNormalisableRange();
    const auto allowed = std::clamp (static_cast<float> (value), range.start, range.end);

    if (static_cast<double> (allowed) != parameterValue (parameter))
        parameter.setValueNotifyingHost (parameter.convertTo0to1 (allowed));
}
} // namespace antinode
