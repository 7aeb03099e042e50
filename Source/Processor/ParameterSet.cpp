#include "ParameterSet.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
GroupBuilder::GroupBuilder (juce::AudioProcessor& owner, const juce::String& identifier, const juce::String& name,
                            std::vector<juce::RangedAudioParameter*>& list)
    : processor (owner), group (std::make_unique<juce::AudioProcessorParameterGroup> (identifier, name, " | ")),
      all (list)
{
}

template <typename Parameter>
Parameter* GroupBuilder::add (std::unique_ptr<Parameter> parameter)
{
    auto* const plain = parameter.get();
    group->addChild (std::move (parameter));
    all.push_back (plain);
    return plain;
}

NumberParameter* GroupBuilder::number (const juce::String& identifier, const juce::String& name, const char* unit,
                                       ParameterRange range, double initial, NumberTexts texts)
{
    return add (std::make_unique<NumberParameter> (juce::ParameterID { identifier, 1 }, name, range, initial,
                                                   std::move (texts), juce::String::fromUTF8 (unit)));
}

IntegerParameter* GroupBuilder::integer (const juce::String& identifier, const juce::String& name, int maximum,
                                         IntegerTexts texts, int initial)
{
    return add (std::make_unique<IntegerParameter> (juce::ParameterID { identifier, 1 }, name, maximum,
                                                    std::move (texts), processor.wrapperType, initial));
}

IntegerParameter* GroupBuilder::choice (const juce::String& identifier, const juce::String& name,
                                        const std::vector<juce::String>& words, int initial)
{
    const auto maximum = static_cast<int> (words.size()) - 1;
    return integer (identifier, name, maximum, wordTexts (words), initial);
}

SwitchParameter* GroupBuilder::flag (const juce::String& identifier, const juce::String& name, bool initial,
                                     const char* on, const char* off, bool isAutomatable)
{
    return add (std::make_unique<SwitchParameter> (juce::ParameterID { identifier, 1 }, name, initial,
                                                   flagTexts (on, off), isAutomatable));
}

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
