#include "GroupBuilder.h"

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
} // namespace antinode
