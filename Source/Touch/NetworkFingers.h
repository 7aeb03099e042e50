#pragma once

#include "TouchParameters.h"
#include "TouchedFingers.h"

#include <antinode_touch/TouchReceiver.h>

#include <juce_events/juce_events.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>

namespace antinode
{
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
    std::string refusal;
    std::atomic<bool> isRefused { false };
    std::chrono::steady_clock::time_point lastTry;
};
} // namespace antinode
