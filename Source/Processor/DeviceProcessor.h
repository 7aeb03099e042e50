#pragma once

#include "DescribedModel.h"
#include "ParameterSet.h"
#include "VST3Extensions.h"

#include <antinode_graph/MidiTriggers.h>
#include <antinode_session/DevicePath.h>
#include <antinode_session/Following.h>
#include <antinode_session/InstrumentMeters.h>
#include <antinode_session/SessionOwner.h>
#include <antinode_session/SessionState.h>
#include <antinode_session/UserMessages.h>
#include <juce_audio_processors/juce_audio_processors.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace antinode
{
/** Calls a function on JUCE's message thread after something has changed, once for many changes. In a plug-in that
   thread is none of the host's, which makes and frees the plug-in meanwhile: so nothing is called before begin() or
   once end() has returned. */
class ChangeMessages
{
public:
    explicit ChangeMessages (std::function<void()> toCall);
    ~ChangeMessages();
    ChangeMessages (const ChangeMessages&) = delete;
    ChangeMessages& operator= (const ChangeMessages&) = delete;

    /** Calls from now on, and the first time for what has changed before. [any but the audio thread] */
    void begin();

    /** Waits for a call that is under way. [any but the audio thread] */
    void end();

    /** Something has changed. [any but the audio thread] */
    void post();

private:
    struct Link;

    std::shared_ptr<Link> link; ///< Messages keep it too.
};

/** What all our plug-ins are to a host: buses whose channels have fixed wires, a device that is loaded and kept in the
    state, parameters whose texts are in its mm, a latency and a tail that may change. What becomes of samples is left
   to RoleProcessor, one for each SessionRole. The standalone program has them too. */
class DeviceProcessor : public juce::AudioProcessor, public VST3Extensions
{
public:
    static constexpr int maximumCeramics = 64; ///< Channels of a bus.
    static constexpr int mostMonitors = 2;

    /** The loaded device. [any but the audio thread] */
    std::shared_ptr<const DeviceDocument> device() const;

    /** What a session plays. */
    struct Playing
    {
        std::shared_ptr<const ModalModel> model; ///< None before the first device is solved.
        std::string error;                       ///< Why the device that was asked for cannot be played.
        std::int64_t latency = 0;                ///< Samples.
        LevelMeters* meters = nullptr;           ///< Live as long as the processor; none: it has none.
        const FollowingRequests* following = nullptr;
    };

    /** [any but the audio thread] */
    virtual Playing playing() const = 0;

    /** All that a host would keep. [message thread] */
    virtual SessionState state() const = 0;

    /** Goes back to a state. @param isRestored  true where it comes from a file or a host: then a device that requires
       it is disarmed [message thread] */
    virtual void setState (const SessionState&, bool isRestored) = 0;

    /** What the user must know: an unreadable state, missing channels, what cannot be played or followed. [any but the
        audio thread] */
    std::vector<UserMessage> messages() const;

    /** The first warning among them, or empty. [any but the audio thread] */
    juce::String warning() const;

    /** Called on the message thread after the session or the state have changed. [message thread] */
    std::function<void()> onChange;

    void releaseResources() override {}
    bool supportsDoublePrecisionProcessing() const override { return true; }
    bool canAddBus (bool) const override { return false; }
    bool canRemoveBus (bool) const override { return false; }
    bool isBusesLayoutSupported (const BusesLayout&) const override;
    void prepareToPlay (double sampleRate, int longestBlock) override;
    juce::AudioProcessorParameter* getBypassParameter() const override { return &parameterSet().bypass(); }
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
    struct Bus
    {
        juce::String name;
        int channels = 1; ///< At first.
        int most = maximumCeramics;
    };

    /** The main buses, and which others there are. */
    struct Buses
    {
        std::optional<Bus> input;
        Bus output;
        bool hasSensor = false, hasMonitor = false;
    };

    /** @param role  of its states; lasts longer @param first  the device that it starts with [message thread] */
    DeviceProcessor (const Buses&, WrapperType, const SessionRole& role, std::shared_ptr<const DeviceDocument> first);

    /** From now on the host is told of changes; to be called when all is made. [message thread] */
    void begin();

    /** Nothing is called any more; to be called before anything of the derived class is gone. [message thread] */
    void end() { changes.end(); }

    /** Something has changed: the host and onChange are told. [any but the audio thread] */
    void post() { changes.post(); }

    /** Where the session looks at the parameters, every few milliseconds: that is how soon a host is told of a step,
        too. [session's thread] */
    void reportSteps();

    /** Another device is the loaded one; warnings of a state are over. [any but the audio thread] */
    void keep (std::shared_ptr<const DeviceDocument>);

    /** A host's block with its channels in the order of their wires. */
    template <typename Sample>
    struct WiredBlock
    {
        std::array<const Sample*, maximumCeramics> inputs {};
        std::array<Sample*, maximumCeramics + mostMonitors> outputs {};
        AudioBlock<Sample> block;
    };

    /** @return  false where the host has handed over too few channels: then the buffer is silent [audio thread] */
    template <typename Sample>
    bool wire (juce::AudioBuffer<Sample>&, const juce::MidiBuffer&, WiredBlock<Sample>&);

    mutable juce::CriticalSection documents; ///< For what is loaded, as the next line.
    std::shared_ptr<const DeviceDocument> loadedDevice;

private:
    virtual void prepareSession (double sampleRate) = 0;
    virtual ParameterSet& parameterSet() const = 0;
    virtual std::vector<UserMessage> ownMessages() const { return {}; } ///< Of its role.
    virtual void waitUntilSettled (std::span<const FocusEvent> notes) = 0;
    void orderWires();
    static BusesProperties properties (const Buses&, WrapperType);
    int sensorBus() const { return buses.input ? 1 : 0; } ///< Index among the inputs.
    UserMessage missingChannels (const ModalModel*) const;
    void reportLatency();
    void reportChanges();

    Buses buses;
    WrapperType wrapper;
    const SessionRole& role;
    ChangeMessages changes { [this] { reportChanges(); } };
    std::vector<int> inputOrder, outputOrder; ///< Buffer channel of channel k; of outputs those of the monitor follow.
    std::size_t monitors = 0;                 ///< Channels.
    int sensorChannel = -1;                   ///< Of the buffer; below 0: the host does not use the bus.
    MidiTriggers triggers;
    juce::CriticalSection latencyReports; ///< One at a time.
    DescribedModel describedModel;
    double toldTail = 0;       ///< s; of the message thread.
    juce::String stateWarning; ///< Under `documents`.
};

/** A plug-in of one role: its parameters, and the session that looks at them and plays. A role is a class of this in a
    file of its own, with its session and its parameters (Tests/Processor/NewRoleTests.cpp has a tiny one).
    @tparam SessionType     of DeviceRounds, with process (block, controls)
    @tparam ParametersType  a ParameterSet with settings() and controls(), which say isArmed */
template <typename SessionType, typename ParametersType>
class RoleProcessor : public DeviceProcessor
{
public:
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

    SessionType& session() const { return **player; }
    ParametersType& parameters() const { return *controls; }

protected:
    using Settings = decltype (std::declval<ParametersType>().settings());
    using Controls = decltype (std::declval<ParametersType>().controls());

    /** @param role, first  as DeviceProcessor [message thread] */
    RoleProcessor (const Buses& buses, WrapperType wrapper, const SessionRole& role,
                   std::shared_ptr<const DeviceDocument> first)
        : DeviceProcessor (buses, wrapper, role, std::move (first))
    {
        controls = std::make_unique<ParametersType> (
            *this, [this] { return player != nullptr ? session().snapshot()->model : nullptr; });
    }

    /** Starts the session, when all is made that it may ask for. @param documents  what it begins with, by value
        @param more  behind what reads settings and tells of changes [message thread] */
    template <typename Documents, typename... More>
    void start (const Documents& documents, More&&... more)
    {
        player = std::apply (
            [&] (const auto&... each)
            {
                return std::make_unique<SessionThread<SessionType>> (
                    each..., [this] { return look(); }, [this] { post(); }, std::forward<More> (more)...);
            },
            documents);
        begin();
    }

    /** To be called before anything of the derived class is gone: the session's thread asks for it. [message thread] */
    void close()
    {
        end();

        if (player != nullptr)
            session().leave(); // Before the pointer is empty: until then its thread asks for it.

        player.reset();
    }

    /** What the parameters say. [session's thread] */
    virtual Settings look()
    {
        reportSteps();
        return controls->settings();
    }

    /** What the host plays at a sample rate, as the session is asked for it. [any but the audio thread] */
    virtual typename SessionType::Format formatAt (double sampleRate) const { return { sampleRate }; }

    /** Adds what is no parameter. [audio thread] */
    virtual void complete (Controls&) const {}

private:
    void prepareSession (double sampleRate) override { session().prepare (formatAt (sampleRate)); }
    ParameterSet& parameterSet() const override { return *controls; }
    void waitUntilSettled (std::span<const FocusEvent> notes) override { session().waitUntilSettled (notes); }

    template <typename Sample>
    void play (juce::AudioBuffer<Sample>& buffer, const juce::MidiBuffer& midi, bool isBypassed)
    {
        const juce::ScopedNoDenormals noDenormals;

        if (WiredBlock<Sample> wired; wire (buffer, midi, wired))
        {
            auto now = controls->controls();
            complete (now);
            now.isArmed = now.isArmed && ! isBypassed;
            session().process (wired.block, now);

            for (auto i = static_cast<int> (wired.block.outputs.size() + wired.block.monitor.size());
                 i < buffer.getNumChannels(); ++i)
                buffer.clear (i, 0, wired.block.count); // Inputs that are no outputs.
        }
    }

    std::unique_ptr<ParametersType> controls;
    std::unique_ptr<SessionThread<SessionType>> player;
};
} // namespace antinode
