#pragma once

#include "ParameterSet.h"

#include <antinode_session/FocusSettings.h>
#include <antinode_session/PlayControls.h>
#include <antinode_session/PlaySettings.h>

#include <vector>

namespace antinode
{
/** Those of Antinode. Docs/Manual/parameters.md. */
class Parameters : public ParameterSet
{
public:
    /** Adds them to a processor, which owns them. [message thread] */
    Parameters (juce::AudioProcessor&, const SurfaceSource&);

    /** The settings of the focus. [any] */
    PlaySettings settings() const;

    /** The settings that take effect immediately, without mutes. [any] */
    PlayControls controls() const;

    /** Sets the parameters that a focus determines, and tells the host. [any but the audio thread] */
    void setFocus (const PlaySettings&);

    /** Those. [any] */
    std::vector<juce::RangedAudioParameter*> ofFocus() const;

    SwitchParameter& arm() const { return *armed; }

private:
    NumberParameter *x, *y, *width, *peakVelocity, *focusTime, *growth, *brake, *voltageLimit, *probeX, *probeY,
        *monitorGain, *outputTrim;
    IntegerParameter *shape, *method, *modes, *notes, *noteOff, *retrigger;
    SwitchParameter *focusOnNote, *armed;
};
} // namespace antinode
