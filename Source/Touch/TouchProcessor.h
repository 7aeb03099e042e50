#pragma once

#include "TouchedFingers.h"

#include <Processor/DeviceProcessor.h>
#include <Processor/ParameterSet.h>
#include <antinode_session/PlayControls.h>
#include <antinode_session/TouchSession.h>
#include <antinode_touch/TouchReceiver.h>
#include <juce_events/juce_events.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace antinode
{
/** The parameters of one finger. */
struct FingerParameters
{
    NumberParameter *x, *y, *level;
    IntegerParameter *presence, *load;
};

/** Those of Antinode Touch: its fingers, the latency, the output. Docs/Manual/touch-plugin.md. */
class TouchParameters : public ParameterSet
{
public:
    /** Adds them to a processor, which owns them. [message thread] */
    TouchParameters (juce::AudioProcessor&, const SurfaceSource&);

    /** What they say of the filters. [any] */
    TouchSettings settings() const;

    /** What takes effect at once. [any] */
    PlayControls controls() const;

    const FingerParameters& finger (std::size_t index) const { return fingers[index]; }
    IntegerParameter& latency() const { return *chosenLatency; }
    NumberParameter& gain() const { return *outputGain; }
    SwitchParameter& arm() const { return *armed; }

private:
    std::array<FingerParameters, mostFingers> fingers {};
    IntegerParameter* chosenLatency;
    NumberParameter* outputGain;
    SwitchParameter* armed;
};

/** Touches by OSC and TUIO that put down, move and lift the fingers of Antinode Touch, as its parameters. */
class NetworkFingers : private juce::AsyncUpdater
{
public:
    /** @param parametersToSet  outlive this
        @param inputsOf  gives how many fingers have an input
        @param stopFoci  called where touches stop everything, on any thread but the audio thread
        [message thread] */
    NetworkFingers (TouchParameters& parametersToSet, std::function<int()> inputsOf, std::function<void()> stopFoci);
    ~NetworkFingers() override;

    /** Lifts all touches, closes the ports that are open and opens these. Where these are open, they and their touches
        stay; where they were refused, they are tried again. `finger` is what fingers that are put down are to the
        surface, empty: what their parameter says.
        @throws InputError  as TouchReceiver; then none is open, and they are tried again each second
        [any but the audio thread] */
    void open (const TouchPorts&);

    /** What takes commands of the ports that are opened from now on. [any but the audio thread] */
    void setControl (OscControl);

    /** Tries again to open what is wanted and was refused, where the last time was a second ago.
        @return  whether it is open now [any but the audio thread] */
    bool retryWhenDue();

    /** Why what is wanted is not open, in one sentence; empty where it is. [any but the audio thread] */
    std::string failure() const;

    /** What was asked for; 0 where a port is off. [any but the audio thread] */
    TouchPorts wanted() const;

    /** Those that are open. [any but the audio thread] */
    TouchPorts ports() const;

    /** [any but the audio thread] */
    TouchCounters counters() const;

    const TouchedFingers& touches() const { return fingers; }

    /** A touch from elsewhere. [any but the audio thread] */
    void take (const Touch&);

    /** Sets the parameters of what has changed, as a message does so soon. [message thread] */
    void apply();

private:
    void handleAsyncUpdate() override { apply(); }
    void listen();
    void apply (const FingerMove&);

    TouchParameters& parameters;
    std::function<int()> inputs;
    std::function<void()> stop;
    TouchedFingers fingers;
    mutable std::mutex mutex; ///< For the next lines.
    TouchPorts wantedPorts { 0, 0, "127.0.0.1" };
    std::unique_ptr<TouchReceiver> receiver; ///< None: nothing is wanted, or it was refused.
    OscControl control;
    std::string refusal;
    std::atomic<bool> isRefused { false };
    std::chrono::steady_clock::time_point lastTry;
};

/** Antinode Touch: a waveform for each finger in, voltages out.

    The input bus "Fingers" has 1 to 8 channels, channel k for finger k; the output bus "Ceramics" has 1 to 64, channel
   k for ceramic k, 1.0 = the device's full scale; the input bus
   "Sensor" has one channel, or none: what listens to the surface. Before filters are designed, and unprepared, all
   voltages are 0. A device that has to be armed is disarmed when it is loaded or comes back. */
class TouchProcessor : public RoleProcessor<TouchSession, TouchParameters>
{
public:
    static constexpr int maximumFingers = mostFingers;

    /** What the ports are called among the values of a state. */
    static constexpr std::array portKeys { "osc_port", "tuio_port", "touches_from_network" };

    /** @param ceramics  channels of the output at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    TouchProcessor (int ceramics, WrapperType wrapper);
    ~TouchProcessor() override;

    /** Touches by OSC and TUIO, whose ports the state keeps. None are open at first. */
    NetworkFingers& network() { return *touches; }

    /** Ends all that touches and notes have begun: lifts the fingers of touches, fades foci out. [any but the audio
        thread] */
    void stopAll() { touches->take ({ TouchKind::stopAll }); }

    /** Loads a device. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    /** What notes play on top of the tracks; none: nothing. The state keeps it. [message thread] */
    void loadFocus (const std::shared_ptr<const FocusDocument>&);
    std::shared_ptr<const FocusDocument> focus() const { return session().focus(); }

    SessionState state() const override;
    void setState (const SessionState&, bool isRestored) override;

    /** How many fingers have an input. [any] */
    int inputs() const { return getChannelCountOfBus (true, 0); }

    const juce::String getName() const override { return "Antinode Touch"; }
    double getTailLengthSeconds() const override { return session().tailSeconds (parameters().settings().latency); }
    void reset() override { session().stopAll(); }
    bool acceptsMidi() const override { return true; }
    juce::AudioProcessorEditor* createEditor() override;
    Playing playing() const override;
    bool hasEditor() const override { return true; }

private:
    std::vector<UserMessage> ownMessages() const override;
    TouchFormat formatAt (double sampleRate) const override { return { sampleRate, inputs() }; }
    TouchSettings look() override;
    std::map<std::string, double> values() const;
    void setValues (const std::map<std::string, double>&, const DeviceDocument&);
    void openPorts (const std::map<std::string, double>& values);
    std::vector<std::string> touchedKeys (std::initializer_list<const char*> names) const;

    std::unique_ptr<NetworkFingers> touches;
    std::atomic<std::size_t> lookedLatency { 0 }; ///< What the session saw last.
};
} // namespace antinode
