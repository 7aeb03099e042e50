#pragma once

#include "TouchParameters.h"

#include <Processor/ChangeMessages.h>

#include <antinode_session/DeviceState.h>
#include <antinode_session/TouchSession.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** Antinode Touch: a waveform for each finger in, voltages out.

    The input bus "Fingers" has 1 to 8 channels, channel k for finger k; the output bus "Ceramics" has 1 to 64, channel
   k for ceramic k, 1.0 = the device's full scale. Before filters are designed, and unprepared, all voltages are 0. */
class TouchProcessor : public juce::AudioProcessor
{
public:
    static constexpr int maximumCeramics = 64, maximumFingers = mostFingers;

    /** @param ceramics  channels of the output at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    TouchProcessor (int ceramics, WrapperType wrapper);
    ~TouchProcessor() override;

    TouchSession& session() { return *player; }
    TouchParameters& parameters() { return *controls; }

    /** Loads a device; one that has to be armed is disarmed. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    /** The loaded device. [any but the audio thread] */
    std::shared_ptr<const DeviceDocument> device() const;

    /** All that a host would keep, and back: a device that has to be armed comes back disarmed. [message thread] */
    DeviceState state() const;
    void setState (const DeviceState&);

    /** How many fingers have an input. [any] */
    int inputs() const { return getChannelCountOfBus (true, 0); }

    /** What the user must know, in one sentence; empty where all is well. [any but the audio thread] */
    juce::String warning();

    /** Called on the message thread after the session or the state have changed. [message thread] */
    std::function<void()> onChange;

    /** Makes the editor; set by the program that has one. */
    static std::function<juce::AudioProcessorEditor*(TouchProcessor&)> makeEditor;

    const juce::String getName() const override { return "Antinode Touch"; }
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
    double getTailLengthSeconds() const override { return player->tailSeconds(); }
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
    TouchSettings readSettings();

    WrapperType wrapper;
    ChangeMessages changes { [this] { reportChanges(); } };
    std::unique_ptr<TouchParameters> controls;
    std::unique_ptr<TouchSession> player;
    std::vector<int> inputOrder, outputOrder;         ///< Buffer channel of finger k, and of ceramic k.
    std::atomic<std::size_t> lookedLatency { 0 };     ///< What the session saw last.
    juce::CriticalSection latencyReports;             ///< One at a time.
    std::shared_ptr<const ModalModel> describedModel; ///< What the host knows the parameters' texts of.

    mutable juce::CriticalSection documents; ///< For the next lines.
    std::shared_ptr<const DeviceDocument> loadedDevice;
    juce::String stateWarning;
};
} // namespace antinode
