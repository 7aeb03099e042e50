#pragma once

#include "ChangeMessages.h"
#include "DescribedModel.h"
#include "FirstWarning.h"
#include "StepParameters.h"
#include "VST3Extensions.h"

#include <antinode_model/ModalModel.h>
#include <antinode_session/DeviceState.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace antinode
{
/** A block of an effect. */
template <typename Sample>
struct EffectBlock
{
    std::span<const Sample* const> in; ///< Channel k of the input bus.
    std::span<Sample* const> out;
    int count = 0; ///< Samples.
    bool isBypassed = false;
    const Sample* sensor = nullptr; ///< Where the effect has a bus for one and the host uses it.
};

/** What all effects on a device are to a host: one input bus and one output bus whose channels have fixed wires, a
   bus for a sensor where there is one, a device that is loaded and kept in the state, parameters whose texts are in its
   mm, a latency that may change. What becomes of samples is left to those who derive from it. */
class DeviceEffect : public juce::AudioProcessor, public VST3Extensions
{
public:
    /** Loads a device. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    /** The loaded device. [any but the audio thread] */
    std::shared_ptr<const DeviceDocument> device() const;

    /** All that a host would keep, and back. [message thread] */
    DeviceState state() const;
    void setState (const DeviceState&);

    /** What the user must know. [any but the audio thread] */
    std::vector<UserMessage> messages();

    /** The first warning among them, or empty. [any but the audio thread] */
    juce::String warning() { return firstWarning (messages()); }

    /** Called on the message thread after the session or the state have changed. [message thread] */
    std::function<void()> onChange;

    void releaseResources() override {}
    bool supportsDoublePrecisionProcessing() const override { return true; }
    bool canAddBus (bool) const override { return false; }
    bool canRemoveBus (bool) const override { return false; }
    bool isBusesLayoutSupported (const BusesLayout&) const override;
    void prepareToPlay (double sampleRate, int longestBlock) override;
    void processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, false);
    }
    void processBlock (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, false);
    }
    void processBlockBypassed (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, true);
    }
    void processBlockBypassed (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, true);
    }
    bool acceptsMidi() const override { return false; }
    bool producesMidi() const override { return false; }
    int getNumPrograms() override { return 1; }
    int getCurrentProgram() override { return 0; }
    void setCurrentProgram (int) override {}
    const juce::String getProgramName (int) override { return "Default"; }
    void changeProgramName (int, const juce::String&) override {}
    void getStateInformation (juce::MemoryBlock&) override;
    void setStateInformation (const void*, int) override;

protected:
    /** One bus of an effect. */
    struct EffectBus
    {
        juce::String name;
        int channels = 1; ///< At first.
        int most = 1;
    };

    /** Whether an effect has a bus for a sensor. */
    enum class SensorBus
    {
        none,
        one
    };

    static constexpr int mostChannels = 64;

    /** @param schema  of its states @param first  name of the embedded device that it starts with [message thread] */
    DeviceEffect (const EffectBus& input, const EffectBus& output, SensorBus, WrapperType, const char* schema,
                  const std::string& first);

    /** From now on the host is told of changes; to be called when all is made. [message thread] */
    void begin();

    /** Nothing is called any more; to be called before anything of the derived class is gone. [message thread] */
    void end() { changes.end(); }

    /** Something has changed: the host and onChange are told. [any but the audio thread] */
    void post() { changes.post(); }

private:
    virtual void take (std::shared_ptr<const DeviceDocument>) = 0;
    virtual void prepareSession (double sampleRate) = 0;
    virtual std::shared_ptr<const ModalModel> solvedModel() const = 0;
    virtual std::map<std::string, double> values() const = 0;
    virtual void setValues (const std::map<std::string, double>&, const DeviceDocument&) = 0;
    virtual StepReports& stepReports() = 0;
    virtual std::int64_t latencyToReport() const = 0;
    virtual std::vector<UserMessage> ownMessages() = 0;
    virtual std::shared_ptr<const FocusDocument> keptFocus() const { return nullptr; } ///< Of effects that have one.
    virtual void takeFocus (const std::shared_ptr<const FocusDocument>&) {}
    virtual void takeNotes (const juce::MidiBuffer&, int) {} ///< Of the block whose channels come next.
    virtual void playChannels (const EffectBlock<float>&) = 0;
    virtual void playChannels (const EffectBlock<double>&) = 0;
    virtual FollowingSettings keptFollowing() const { return {}; } ///< Of effects that have a sensor.
    virtual void takeFollowing (const FollowingSettings&) {}

    template <typename Sample>
    void play (juce::AudioBuffer<Sample>&, const juce::MidiBuffer&, bool isBypassed);
    void orderWires();
    static BusesProperties buses (const EffectBus& input, const EffectBus& output, SensorBus, WrapperType);
    void reportLatency();
    void reportChanges();

    EffectBus inputBus, outputBus;
    SensorBus sensorBus;
    WrapperType wrapper;
    const char* schema;
    ChangeMessages changes { [this] { reportChanges(); } };
    std::vector<int> inputOrder, outputOrder; ///< Buffer channel of channel k.
    int sensorChannel = -1;                   ///< Of the buffer; below 0: the host does not use the bus.
    juce::CriticalSection latencyReports;     ///< One at a time.
    DescribedModel describedModel;
    double toldTail = 0; ///< s; of the message thread.

    mutable juce::CriticalSection documents; ///< For the next lines.
    std::shared_ptr<const DeviceDocument> loadedDevice;
    juce::String stateWarning;
};
} // namespace antinode
