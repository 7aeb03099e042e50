#pragma once

#include <Processor/NumberParameter.h>
#include <Processor/StepParameters.h>

#include <antinode_session/TouchSession.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** The parameters of one finger. */
struct FingerParameters
{
    NumberParameter *x, *y, *level;
    IntegerParameter *presence, *load;
};

/** The parameters of Antinode Touch: its fingers, the latency, the output. Docs/Manual/touch-plugin.md. */
class TouchParameters
{
public:
    /** Adds them to a processor, which owns them.
        @param surface  the surface that places are texts of; may give none. Called on any thread but the audio thread
        [message thread] */
    TouchParameters (juce::AudioProcessor&, const std::function<std::shared_ptr<const ModalModel>()>& surface);

    /** What they say of the filters. [any] */
    TouchSettings settings() const;

    /** What takes effect at once. [any] */
    TouchControls controls() const;

    /** All by identifier, in the units of their texts. [any] */
    std::map<std::string, double> values() const;

    /** Sets all: those that are not named to their defaults; values beyond a range to its end. Tells the host.
        [message thread] */
    void setValues (const std::map<std::string, double>&);

    const FingerParameters& finger (std::size_t index) const { return fingers[index]; }
    IntegerParameter& latency() const { return *chosenLatency; }
    NumberParameter& gain() const { return *outputGain; }
    SwitchParameter& arm() const { return *armed; }
    SwitchParameter& bypass() const { return *bypassed; }

    /** What the host is to be told of steps that its values lay between. */
    StepReports& stepReports() { return *steps; }

    /** All in the order of the groups. [any] */
    const std::vector<juce::RangedAudioParameter*>& all() const { return ordered; }

private:
    std::array<FingerParameters, mostFingers> fingers {};
    IntegerParameter* chosenLatency;
    NumberParameter* outputGain;
    SwitchParameter *armed, *bypassed;
    std::vector<juce::RangedAudioParameter*> ordered;
    std::unique_ptr<StepReports> steps;
};
} // namespace antinode
