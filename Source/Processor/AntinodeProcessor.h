#pragma once

#include "BufferChannels.h"
#include "ChangeMessages.h"
#include "DescribedModel.h"
#include "FirstWarning.h"
#include "Parameters.h"
#include "VST3Extensions.h"

#include <antinode_graph/MidiTriggers.h>
#include <antinode_session/Session.h>
#include <antinode_session/SessionState.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <atomic>
#include <functional>
#include <memory>

namespace antinode
{
/** The plug-in: parameters, buses and state around a session. The standalone program has one too.

    The input bus "Sensor" has one channel, or none: what listens to the surface. The main output bus "Ceramics" has 1
   to 64 channels, channel k for ceramic k, 1.0 = the device's full scale; the bus "Monitor" has the velocity at the
   probes, 1.0 = 1 m/s. */
class AntinodeProcessor : public juce::AudioProcessor, public VST3Extensions
{
public:
    static constexpr int maximumCeramics = BufferChannels::maximumCeramics;

    /** @param ceramics  channels of the main bus at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    AntinodeProcessor (int ceramics, juce::AudioProcessor::WrapperType wrapper);
    ~AntinodeProcessor() override;

    Session& session() { return *player; }
    Parameters& parameters() { return *controls; }

    /** Loads a device, a focus, or both, and sets the parameters to the focus. Another device alone gets a focus that
       suits it as soon as it is solved. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>);

    /** Puts other fingers on the surface; parameters stay as they are. Touches among them remain touches.
        @throws InputError  as withFingers; then nothing is changed [message thread] */
    void setFingers (const std::vector<Finger>&);

    /** Puts other touches beside the fingers of the focus. They are on the surface of this focus only, and in no state.
        @throws InputError  as withFingers; then nothing is changed [message thread] */
    void setTouches (const std::vector<Finger>&);

    /** Those that are on the surface, as focus() has them behind the fingers of its own. [any but the audio thread] */
    std::vector<Finger> touches() const;

    /** The complete state for a host, without touches. [message thread] */
    SessionState state() const;

    /** Goes back to a state. @param isRestored  true where it comes from a file or a host: then a device that requires
       it is disarmed [message thread] */
    void setState (const SessionState&, bool isRestored);

    /** The loaded device, and the focus with the touches on its surface. [any but the audio thread] */
    std::shared_ptr<const DeviceDocument> device() const;
    std::shared_ptr<const FocusDocument> focus() const;

    /** Bit i: ceramic i + 1 is muted. [any] */
    std::uint64_t mutes() const { return mutedCeramics; }
    void setMutes (std::uint64_t mask) { mutedCeramics = mask; }

    /** What the user must know: an unreadable state, missing channels, what cannot be designed or followed. [any but
       the audio thread] */
    std::vector<UserMessage> messages() const;

    /** The first warning among them, or empty. [any but the audio thread] */
    juce::String warning() const { return firstWarning (messages()); }

    /** Called on the message thread after the session or the state have changed. [message thread] */
    std::function<void()> onChange;

    /** Creates the editor; set by programs that have one, so that programs without an editor do not need it. */
    static std::function<juce::AudioProcessorEditor*(AntinodeProcessor&)> makeEditor;

    const juce::String getName() const override { return "Antinode"; }
    void prepareToPlay (double sampleRate, int longestBlock) override;
    void releaseResources() override {}
    void reset() override;
    bool getPluginHasMainInput() const override { return false; }
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
    bool acceptsMidi() const override { return true; }
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
    void play (juce::AudioBuffer<Sample>&, const juce::MidiBuffer&, bool isBypassed);
    std::shared_ptr<const FocusDocument> keptFocus() const;
    bool takeFocus (const std::shared_ptr<const FocusDocument>& chosen, const FocusDocument& before);
    void putDown (const std::vector<Finger>& own, const std::vector<Finger>& touching);
    void reportLatency();
    void reportChanges();
    PlaySettings readSettings();
    void setWarning (const juce::String&);

    WrapperType wrapper;
    ChangeMessages changes { [this] { reportChanges(); } };
    std::unique_ptr<Parameters> controls;
    std::unique_ptr<Session> player;
    MidiTriggers triggers { VelocityCurve {} };
    std::atomic<std::uint64_t> mutedCeramics { 0 };
    BufferChannels bufferChannels;
    juce::CriticalSection latencyReports; ///< One at a time.
    DescribedModel describedModel;
    double toldTail = 0; ///< s; of the message thread.

    mutable juce::CriticalSection documents; ///< For the next lines.
    std::shared_ptr<const DeviceDocument> loadedDevice;
    std::shared_ptr<const FocusDocument> loadedFocus, touchedFocus; ///< As it is kept, and with touches.
    juce::String stateWarning;
};

/** The embedded demonstrator: the initial state. [worker] */
SessionState demonstrator();
} // namespace antinode
