#pragma once

#include "NumberParameter.h"
#include "StepParameters.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>
#include <vector>

namespace antinode
{
/** Adds parameters to a group and keeps a plain pointer to each. [message thread] */
class GroupBuilder
{
public:
    GroupBuilder (juce::AudioProcessor&, const juce::String& identifier, const juce::String& name,
                  std::vector<juce::RangedAudioParameter*>& list);

    NumberParameter* number (const juce::String& identifier, const juce::String& name, const char* unit, ParameterRange,
                             double initial, NumberTexts);

    IntegerParameter* integer (const juce::String& identifier, const juce::String& name, int maximum, IntegerTexts,
                               int initial = 0);

    /** A choice of words: an integer, since JUCE's LV2 wrapper gives choices wrong scale points. */
    IntegerParameter* choice (const juce::String& identifier, const juce::String& name,
                              const std::vector<juce::String>& words, int initial = 0);

    SwitchParameter* flag (const juce::String& identifier, const juce::String& name, bool initial, const char* on,
                           const char* off, bool isAutomatable = true);

    void addToProcessor() { processor.addParameterGroup (std::move (group)); }

private:
    template <typename Parameter>
    Parameter* add (std::unique_ptr<Parameter>);

    juce::AudioProcessor& processor;
    std::unique_ptr<juce::AudioProcessorParameterGroup> group;
    std::vector<juce::RangedAudioParameter*>& all;
};
} // namespace antinode
