#pragma once

#include "PlateParameters.h"

#include <Processor/DeviceProcessor.h>

#include <antinode_session/PlateSession.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace antinode
{
/** Antinode Plate: voltages in, velocities out.

    The input bus "Voltages" has 1 to 64 channels, channel k for ceramic k, 1.0 = the device's full scale; the
    output bus "Probes" has 1 to 8, 1.0 = 1 m/s. Before a device is solved, and unprepared, the probes are silent. */
class PlateProcessor : public DeviceProcessor
{
public:
    static constexpr int maximumProbes = PlatePath::probes;

    /** @param ceramics  channels of the input at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    PlateProcessor (int ceramics, WrapperType wrapper);
    ~PlateProcessor() override;

    PlateSession& session() const { return **surface; }
    PlateParameters& parameters() { return *controls; }

    /** Loads a device. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    SessionState state() const override { return { device(), {}, controls->values() }; }
    void setState (const SessionState&, bool isRestored) override;

    /** How many probes have an output. [any] */
    int shownProbes() const { return std::min (maximumProbes, getChannelCountOfBus (false, 0)); }

    const juce::String getName() const override { return "Antinode Plate"; }
    double getTailLengthSeconds() const override { return session().tailSeconds(); }
    juce::AudioProcessorEditor* createEditor() override;
    bool hasEditor() const override { return true; }

private:
    void prepareSession (double sampleRate) override { session().prepare (sampleRate); }
    ParameterSet& parameterSet() const override { return *controls; }
    Playing playing() const override;
    void waitUntilSettled (std::span<const FocusEvent>) override { session().waitUntilSettled(); }
    void playBlock (const AudioBlock<float>&, bool isBypassed) override;
    void playBlock (const AudioBlock<double>&, bool isBypassed) override;
    template <typename Sample>
    void playSurface (const AudioBlock<Sample>&, bool isBypassed);

    std::unique_ptr<PlateParameters> controls;
    std::unique_ptr<SessionThread<PlateSession>> surface;
};
} // namespace antinode
