#include "ParameterSet.h"

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

std::map<std::string, double> ParameterSet::values() const
{
    std::map<std::string, double> named;

    for (const auto* const parameter : ordered)
        named[parameter->getParameterID().toStdString()] = parameterValue (*parameter);

    return named;
}

void ParameterSet::setValues (const std::map<std::string, double>& named)
{
    for (auto* const parameter : ordered)
    {
        const auto found = named.find (parameter->getParameterID().toStdString());
        const auto initial = static_cast<double> (parameter->convertFrom0to1 (parameter->getDefaultValue()));
        setValue (*parameter, found == named.end() ? initial : found->second);
    }
}

juce::RangedAudioParameter* ParameterSet::find (const std::string& identifier) const
{
    const auto found =
        std::find_if (ordered.begin(), ordered.end(),
                      [&] (const auto* parameter) { return parameter->getParameterID() == juce::String (identifier); });
    return found == ordered.end() ? nullptr : *found;
}
} // namespace antinode
