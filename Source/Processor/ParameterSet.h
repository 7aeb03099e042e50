#pragma once

#include "ParameterTypes.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
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

struct ModalModel;

/** The surface that places are texts of; may give none. Called on any thread but the audio thread. */
using SurfaceSource = std::function<std::shared_ptr<const ModalModel>()>;

/** The parameters that the hosts of a plug-in automate, in groups. */
class ParameterSet
{
public:
    /** All by identifier, in the units of their texts. [any] */
    std::map<std::string, double> values() const;

    /** Sets all: those that are not named to their defaults; values beyond a range to its end. Tells the host. [message
        thread] */
    void setValues (const std::map<std::string, double>&);

    SwitchParameter& bypass() const { return *bypassed; }

    /** What the host is to be told of steps that its values lay between. */
    StepReports& stepReports() { return *steps; }

    /** The parameter of an identifier, for controls of an editor. @return  never null for an identifier of ours [any]
     */
    juce::RangedAudioParameter* find (const std::string& identifier) const;

    /** All in the order of the groups. [any] */
    const std::vector<juce::RangedAudioParameter*>& all() const { return ordered; }

protected:
    ParameterSet() = default;
    ~ParameterSet() = default;

    /** Once all belong to the processor. [message thread] */
    void begin() { steps = std::make_unique<StepReports> (ordered); }

    std::vector<juce::RangedAudioParameter*> ordered;
    SwitchParameter* bypassed = nullptr;

private:
    std::unique_ptr<StepReports> steps;
};

/** A value in the unit of the parameter's text, to the bit. [any] */
double parameterValue (const juce::RangedAudioParameter&);

/** Sets what parameterValue gave, to the bit; values beyond the range to its end, one that is not finite not at all.
    Tells the host where it changes. [any but the audio thread] */
void setValue (juce::RangedAudioParameter&, double value);
} // namespace antinode
