#include "ParameterValues.h"

#include "NumberParameter.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
double parameterValue (const juce::RangedAudioParameter& parameter)
{
    if (const auto* const number = dynamic_cast<const NumberParameter*> (&parameter))
        return number->get();

    return static_cast<double> (parameter.convertFrom0to1 (parameter.getValue()));
}

void setValue (juce::RangedAudioParameter& parameter, double value)
{
    if (auto* const number = dynamic_cast<NumberParameter*> (&parameter))
    {
        *number = value;
        return;
    }

    if (! std::isfinite (value))
        return;

    const auto range = parameter.getNormalisableRange();
    const auto allowed = std::clamp (static_cast<float> (value), range.start, range.end);

    if (static_cast<double> (allowed) != parameterValue (parameter))
        parameter.setValueNotifyingHost (parameter.convertTo0to1 (allowed));
}

std::map<std::string, double> parameterValues (const std::vector<juce::RangedAudioParameter*>& parameters)
{
    std::map<std::string, double> named;

    for (const auto* const parameter : parameters)
        named[parameter->getParameterID().toStdString()] = parameterValue (*parameter);

    return named;
}

void setParameterValues (const std::vector<juce::RangedAudioParameter*>& parameters,
                         const std::map<std::string, double>& named)
{
    for (auto* const parameter : parameters)
    {
        const auto found = named.find (parameter->getParameterID().toStdString());
        const auto initial = static_cast<double> (parameter->convertFrom0to1 (parameter->getDefaultValue()));
        setValue (*parameter, found == named.end() ? initial : found->second);
    }
}
} // namespace antinode
