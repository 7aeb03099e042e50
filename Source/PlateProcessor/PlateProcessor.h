#pragma once

#include "PlateParameters.h"

#include <Processor/ChangeMessages.h>

#include <antinode_session/DeviceState.h>
#include <antinode_session/PlateSession.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** Antinode Plate: voltages in, velocities out.

    The input bus "Voltages" has 1 to 64 channels, channel k for ceramic k, 1.0 = the device's full scale; the
    output bus "Probes" has 1 to 8, 1.0 = 1 m/s. Before a device is solved, and unprepared, the probes are silent. */
class PlateProcessor : public juce::AudioProcessor
{
public:
    static constexpr int maximumCeramics = 64, maximumProbes = PlatePath::probes;

    /** @param ceramics  channels of the input at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    PlateProcessor (int ceramics, WrapperType wrapper);
    ~PlateProcessor() override;

    PlateSession& session() { return *surface; }
    PlateParameters& parameters() { return *controls; }

    /** Loads a device. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    /** The loaded device. [any but the audio thread] */
    std::shared_ptr<const DeviceDocument> device() const;

    /** All that a host would keep, and back. [message thread] */
    DeviceState state() const;
    void setState (const DeviceState&);

    /** How many probes have an output. [any] */
    int shownProbes() const { return std::min (maximumProbes, getChannelCountOfBus (false, 0)); }

    /** What the user must know, in one sentence; empty where all is well. [any but the audio thread] */
    juce::String warning();

    /** Called on the message thread after the session or the state have changed. [message thread] */
    std::function<void()> onChange;

    /** Makes the editor; set by the program that has one. */
    static std::function<juce::AudioProcessorEditor*(PlateProcessor&)> makeEditor;

    const juce::String getName() const override { return "Antinode Plate"; }
    void prepareToPlay (double sampleRate, int longestBlock) override;
    void releaseResources() override {}
    bool supportsDoublePrecisionProcessing() const override { return true; }
    bool isBusesLayoutSupported (const BusesLayout&) const override;
    bool canAddBus (bool) const override { return false; }
    bool canRemoveBus (bool) const override { return false; }
    void processBlock (juce::AudioBuffer<float>&, juce::MidiBuffer&) override;
    void processBlock (juce::AudioBuffer<double>&, juce::MidiBuffer&) override;
    void processBlockBypassed (juce::AudioBuffer<float>&, juce::MidiBuffer&) override;
    void processBlockBypassed (juce::AudioBuffer<double>&, juce::MidiBuffer&) override;
    juce::AudioProcessorParameter* getBypassParameter() const override { return &controls->bypass(); }
    double getTailLengthSeconds() const override { return surface->tailSeconds(); }
    bool acceptsMidi() const override { return false; }
    bool producesMidi() const override { return false; }
    juce::AudioProcessorEditor* createEditor() override { return makeEditor ? makeEditor (*this) : nullptr; }
    bool hasEditor() const override { return makeEditor != nullptr; }
    int getNumPrograms() override { return 1; }
    int getCurrentProgram() override { return 0; }
    void setCurrentProgram (int) override {}
    const juce::String getProgramName (int) override { return "Default"; }
    void changeProgramName (int, const juce::String&) override {}
    void getStateInformation (juce::MemoryBlock&) override;
    void setStateInformation (const void*, int) override;

private:
    static BusesProperties busesFor (int ceramics, WrapperType);
    template <typename Sample>
    void play (juce::AudioBuffer<Sample>&, bool isBypassed);
    void reportLatency();
    void reportChanges();
    SurfaceSettings readSettings();

    WrapperType wrapper;
    ChangeMessages changes { [this] { reportChanges(); } };
    std::unique_ptr<PlateParameters> controls;
    std::unique_ptr<PlateSession> surface;
    std::vector<int> inputOrder, outputOrder;         ///< Buffer channel of ceramic k, and of probe k.
    juce::CriticalSection latencyReports;             ///< One at a time.
    std::shared_ptr<const ModalModel> describedModel; ///< What the host knows the parameters' texts of.

    mutable juce::CriticalSection documents; ///< For the next lines.
    std::shared_ptr<const DeviceDocument> loadedDevice;
    juce::String stateWarning;
};
} // namespace antinode
