#pragma once

#include <Processor/ParameterSet.h>

#include <antinode_session/PlateSession.h>

#include <array>

namespace antinode
{
/** Those of Antinode Plate: where its probes are, their gain, and how the surface is computed.
    Docs/Manual/plate-plugin.md. */
class PlateParameters : public ParameterSet
{
public:
    /** Adds them to a processor, which owns them. [message thread] */
    PlateParameters (juce::AudioProcessor&, const SurfaceSource&);

    /** What they say of the surface. [any] */
    SurfaceSettings settings() const;

    /** What takes effect at once. [any] */
    SurfaceControls controls() const;

    NumberParameter& probeX (int probe) const { return *places[static_cast<std::size_t> (probe)].x; }
    NumberParameter& probeY (int probe) const { return *places[static_cast<std::size_t> (probe)].y; }

private:
    struct Place
    {
        NumberParameter *x, *y;
    };

    std::array<Place, PlatePath::probes> places {};
    NumberParameter* gain;
    SwitchParameter* quick;
};
} // namespace antinode
