#pragma once

#include "AudioPath.h"
#include "SessionSnapshot.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace antinode
{

/** A focus that is to be fired at another position: m, and its amplitude from 0 to 1. */
struct SessionTouch
{
    double x = 0, y = 0, amplitude = 1;
    std::uint64_t askedAt = 0; ///< StopCount::now() then.
};

/** Takes over a focus in place of another one. @return  false where that one is not the present one any more */
using TakeFocus = std::function<bool (const std::shared_ptr<const FocusDocument>& chosen, const FocusDocument& before)>;

/** What is new in a round of a session's thread. */
struct SessionRound
{
    std::uint64_t number = 0;
    std::shared_ptr<const DeviceDocument> device; ///< None: the present one stays; so with the focus.
    std::shared_ptr<const FocusDocument> focus;
    bool choosesFocus = false; ///< Whether the device came without a focus.
    double sampleRate = 0;     ///< Hz; 0 before the first preparation.
    GraphChoice graph;
    bool isInsertionNew = false, isOrderNew = false;
    std::vector<int> firstNotes;    ///< Are designed before the others.
    std::vector<double> amplifiers; ///< V of a full-scale sample of each ceramic; 0 or missing: the device's.
    std::vector<SessionTouch> touches;
    std::optional<std::vector<int>> awaited; ///< Places of the bank, if somebody waits for their designs.
};

/** What a session's thread is asked for, and what it answers: all that both sides share under one lock. Front ends ask;
   the session's thread works in rounds, which may be waited for. */
class SessionRequests
{
public:
    using Milliseconds = std::chrono::milliseconds;

    SessionRequests (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>, int firstNote);

    /** None: the present one stays. [any but the audio thread] */
    void load (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>);

    /** The focus that was loaded last. [any but the audio thread] */
    std::shared_ptr<const FocusDocument> newestFocus() const;

    /** The session has chosen this one for a device that came without. [session's thread] */
    void adopt (std::shared_ptr<const FocusDocument>);

    /** [any but the audio thread] */
    void designFirst (std::vector<int> notes);
    void insertNodes (InsertNodes);
    void setAmplifiers (std::vector<double> volts);

    /** [any] */
    void setGraphOpen (bool shouldBeOpen) { wantsOpenGraph = shouldBeOpen; }
    bool isGraphOpen() const { return wantsOpenGraph; }

    /** Those from before its last stop wait no longer. @return  whether it was taken: not where too many wait [any but
     * the audio thread] */
    bool touch (const SessionTouch&);

    /** Asks for the path of a sample rate, and waits until it is there and its focus designed, or the patience has
        ended. [worker] */
    void prepare (double sampleRate, Milliseconds patience);

    /** Waits until all that was asked for is done, and these places of the bank are designed. [any but a real-time
        audio thread] */
    void waitUntilSettled (std::vector<int> places);

    /** Ends the session's thread as soon as its work lets it. [any but the audio thread] */
    void stop();

    /** Whether the session's thread is to end. [any] */
    bool isStopping() const { return stopping; }

    /** Whether a device waits to be taken. [any but the audio thread] */
    bool hasDevice() const;

    /** Whether a focus does. [any but the audio thread] */
    bool hasFocus() const;

    /** Waits for a request, a few milliseconds at most: settings are looked at so often. @return  none at the end
        [session's thread] */
    std::optional<SessionRound> next();

    /** Ends a round. [session's thread] */
    void finish (std::uint64_t round, DesignProgress);

    /** Gives it the next generation. [session's thread] */
    void publish (SessionSnapshot);

    /** [any but the audio thread] */
    std::shared_ptr<const SessionSnapshot> snapshot() const;
    DesignProgress progress() const;
    void setProgress (DesignProgress);

    /** Samples from a trigger to its focus if foci are delayed onto notes, else 0. [any] */
    std::int64_t latencySamples() const { return latency; }
    void setLatencySamples (std::int64_t samples) { latency = samples; }

    /** How long the device is heard after a voltage: its lag, and 60 dB of decay of the slowest mode. s [any] */
    double ringingSeconds() const { return ringing; }
    void setRingingSeconds (double seconds) { ringing = seconds; }

private:
    std::atomic<bool> wantsOpenGraph { false }, stopping { false };
    std::atomic<std::int64_t> latency { 0 };
    std::atomic<double> ringing { 1 };
    mutable std::mutex mutex; ///< For all that follows, and what ends a wait is changed under it.
    std::condition_variable wake, settled;
    SessionRound asked; ///< So far, for the next round.
    std::shared_ptr<const FocusDocument> newest;
    std::uint64_t roundsRequested = 0, settleRequested = 0, roundsDone = 0; ///< Rounds that others wait for.
    std::vector<int> settlePlaces;
    DesignProgress designs;
    std::shared_ptr<const SessionSnapshot> published;
};
} // namespace antinode
