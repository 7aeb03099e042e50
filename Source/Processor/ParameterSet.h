#pragma once

#include "NumberParameter.h"
#include "StepParameters.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
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
