#pragma once

#include "PlateParameters.h"

#include <Processor/DeviceEffect.h>

#include <antinode_session/PlateSession.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace antinode
{
/** Antinode Plate: voltages in, velocities out.

    The input bus "Voltages" has 1 to 64 channels, channel k for ceramic k, 1.0 = the device's full scale; the
    output bus "Probes" has 1 to 8, 1.0 = 1 m/s. Before a device is solved, and unprepared, the probes are silent. */
class PlateProcessor : public DeviceEffect
{
public:
    static constexpr int maximumCeramics = mostChannels, maximumProbes = PlatePath::probes;

    /** @param ceramics  channels of the input at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    PlateProcessor (int ceramics, WrapperType wrapper);
    ~PlateProcessor() override;

    PlateSession& session() { return *surface; }
    PlateParameters& parameters() { return *controls; }

    /** How many probes have an output. [any] */
    int shownProbes() const { return std::min (maximumProbes, getChannelCountOfBus (false, 0)); }

    /** Makes the editor; set by the program that has one. */
    static std::function<juce::AudioProcessorEditor*(PlateProcessor&)> makeEditor;

    const juce::String getName() const override { return "Antinode Plate"; }
    juce::AudioProcessorParameter* getBypassParameter() const override { return &controls->bypass(); }
    double getTailLengthSeconds() const override { return surface->tailSeconds(); }
    juce::AudioProcessorEditor* createEditor() override { return makeEditor ? makeEditor (*this) : nullptr; }
    bool hasEditor() const override { return makeEditor != nullptr; }

private:
    void take (std::shared_ptr<const DeviceDocument> device) override { surface->load (std::move (device)); }
    void prepareSession (double sampleRate) override { surface->prepare (sampleRate); }
    std::shared_ptr<const ModalModel> solvedModel() const override { return surface->snapshot()->model; }
    std::map<std::string, double> values() const override { return controls->values(); }
    void setValues (const std::map<std::string, double>& to, const DeviceDocument&) override
    {
        controls->setValues (to);
    }
    StepReports& stepReports() override { return controls->stepReports(); }
    std::int64_t latencyToReport() const override { return surface->latencySamples(); }
    std::vector<UserMessage> ownMessages() override;
    void playChannels (const EffectBlock<float>&) override;
    void playChannels (const EffectBlock<double>&) override;
    template <typename Sample>
    void playSurface (const SurfaceBlock<Sample>&, bool isBypassed);
    SurfaceSettings readSettings();

    std::unique_ptr<PlateParameters> controls;
    std::unique_ptr<PlateSession> surface;
};
} // namespace antinode
