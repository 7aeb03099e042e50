#pragma once

#include <Processor/DeviceProcessor.h>
#include <Processor/ParameterSet.h>
#include <antinode_session/PlateSession.h>

#include <algorithm>
#include <array>
#include <memory>

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

/** Antinode Plate: voltages in, velocities out.

    The input bus "Voltages" has 1 to 64 channels, channel k for ceramic k, 1.0 = the device's full scale; the
    output bus "Probes" has 1 to 8, 1.0 = 1 m/s. Before a device is solved, and unprepared, the probes are silent. */
class PlateProcessor : public RoleProcessor<PlateSession, PlateParameters>
{
public:
    static constexpr int maximumProbes = PlatePath::probes;

    /** @param ceramics  channels of the input at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    PlateProcessor (int ceramics, WrapperType wrapper);
    ~PlateProcessor() override;

    /** Loads a device. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    SessionState state() const override { return { device(), {}, parameters().values() }; }
    void setState (const SessionState&, bool isRestored) override;

    /** How many probes have an output. [any] */
    int shownProbes() const { return std::min (maximumProbes, getChannelCountOfBus (false, 0)); }

    const juce::String getName() const override { return "Antinode Plate"; }
    double getTailLengthSeconds() const override { return session().tailSeconds(); }
    juce::AudioProcessorEditor* createEditor() override;
    Playing playing() const override;
    bool hasEditor() const override { return true; }

private:
};
} // namespace antinode
