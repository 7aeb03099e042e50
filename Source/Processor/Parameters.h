#pragma once

#include "NumberParameter.h"
#include "StepParameters.h"

#include <antinode_session/FocusSettings.h>
#include <antinode_session/PlaySettings.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** The parameters that hosts automate, in groups. Docs/Manual/parameters.md. */
class Parameters
{
public:
    /** Adds them to a processor, which owns them.
        @param surface  the surface that places are texts of; may give none. Called on any thread but the audio thread
        [message thread] */
    Parameters (juce::AudioProcessor&, const std::function<std::shared_ptr<const ModalModel>()>& surface);

    /** The settings of the focus. [any] */
    PlaySettings settings() const;

    /** The settings that take effect immediately, without mutes. [any] */
    PlayControls controls() const;

    /** Sets the parameters that a focus determines, and tells the host. [any but the audio thread] */
    void setFocus (const PlaySettings&);

    /** Those. [any] */
    std::vector<juce::RangedAudioParameter*> ofFocus() const;

    /** All by identifier, in the units of their texts. [any] */
    std::map<std::string, double> values() const;

    /** Sets all: those that are not named to their defaults; values beyond a range to its end. Tells the host. [message
        thread] */
    void setValues (const std::map<std::string, double>&);

    SwitchParameter& bypass() const { return *bypassed; }
    SwitchParameter& arm() const { return *armed; }

    /** What the host is to be told of steps that its values lay between. */
    StepReports& stepReports() { return *steps; }

    /** The parameter of an identifier, for controls of an editor. @return  never null for an identifier of ours [any]
     */
    juce::RangedAudioParameter* find (const std::string& identifier) const;

    /** All in the order of the groups. [any] */
    const std::vector<juce::RangedAudioParameter*>& all() const { return ordered; }

private:
    NumberParameter *x, *y, *width, *peakVelocity, *focusTime, *growth, *brake, *voltageLimit, *probeX, *probeY,
        *monitorGain, *outputTrim;
    IntegerParameter *shape, *method, *modes, *notes, *noteOff, *retrigger;
    SwitchParameter *focusOnNote, *armed, *bypassed;
    std::vector<juce::RangedAudioParameter*> ordered;
    std::unique_ptr<StepReports> steps;
};
} // namespace antinode
