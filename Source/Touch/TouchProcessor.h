#pragma once

#include "NetworkFingers.h"
#include "TouchParameters.h"

#include <Processor/RoleProcessor.h>

#include <antinode_session/TouchSession.h>

#include <array>
#include <atomic>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
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
