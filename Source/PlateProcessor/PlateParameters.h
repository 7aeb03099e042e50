#pragma once

#include <Processor/NumberParameter.h>
#include <Processor/StepParameters.h>

#include <antinode_session/PlateSession.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** The parameters of Antinode Plate: where its probes are, their gain, and how the surface is computed.
    Docs/Manual/plate-plugin.md. */
class PlateParameters
{
public:
    /** Adds them to a processor, which owns them.
        @param surface  the surface that places are texts of; may give none. Called on any thread but the audio thread
        [message thread] */
    PlateParameters (juce::AudioProcessor&, const std::function<std::shared_ptr<const ModalModel>()>& surface);

    /** What they say of the surface. [any] */
    SurfaceSettings settings() const;

    /** What takes effect at once. [any] */
    SurfaceControls controls() const;

    /** All by identifier, in the units of their texts. [any] */
    std::map<std::string, double> values() const;

    /** Sets all: those that are not named to their defaults; values beyond a range to its end. Tells the host.
        [message thread] */
    void setValues (const std::map<std::string, double>&);

    SwitchParameter& bypass() const { return *bypassed; }
    NumberParameter& probeX (int probe) const { return *places[static_cast<std::size_t> (probe)].x; }
    NumberParameter& probeY (int probe) const { return *places[static_cast<std::size_t> (probe)].y; }

    /** What the host is to be told of steps that its values lay between. */
    StepReports& stepReports() { return *steps; }

    /** All in the order of the groups. [any] */
    const std::vector<juce::RangedAudioParameter*>& all() const { return ordered; }

private:
    struct Place
    {
        NumberParameter *x, *y;
    };

    std::array<Place, PlatePath::probes> places {};
    NumberParameter* gain;
    SwitchParameter *quick, *bypassed;
    std::vector<juce::RangedAudioParameter*> ordered;
    std::unique_ptr<StepReports> steps;
};
} // namespace antinode
