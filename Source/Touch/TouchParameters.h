#pragma once

#include <Processor/ParameterSet.h>

#include <antinode_session/PlayControls.h>

#include <array>

namespace antinode
{
/** The parameters of one finger. */
struct FingerParameters
{
    NumberParameter *x, *y, *level;
    IntegerParameter *presence, *load;
};

/** Those of Antinode Touch: its fingers, the latency, the output. Docs/Manual/touch-plugin.md. */
class TouchParameters : public ParameterSet
{
public:
    /** Adds them to a processor, which owns them. [message thread] */
    TouchParameters (juce::AudioProcessor&, const SurfaceSource&);

    /** What they say of the filters. [any] */
    TouchSettings settings() const;

    /** What takes effect at once. [any] */
    PlayControls controls() const;

    const FingerParameters& finger (std::size_t index) const { return fingers[index]; }
    IntegerParameter& latency() const { return *chosenLatency; }
    NumberParameter& gain() const { return *outputGain; }
    SwitchParameter& arm() const { return *armed; }

private:
    std::array<FingerParameters, mostFingers> fingers {};
    IntegerParameter* chosenLatency;
    NumberParameter* outputGain;
    SwitchParameter* armed;
};
} // namespace antinode
