#pragma once

#include "TouchMessages.h"

#include <juce_core/juce_core.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

namespace antinode
{
/** UDP ports: 0 = off, 1 to 65535, or `anyFree`. Each takes OSC and TUIO alike; they are two because senders have two
    customs. */
struct TouchPorts
{
    static constexpr int anyFree = -1;

    int oscPort = 9000;
    int tuioPort = 3333;

    /** IPv4, of the listening interface: 127.0.0.1 accepts this computer only, 0.0.0.0 the whole network. */
    std::string address = "127.0.0.1";

    /** What TUIO cursors rest on the surface: a kind of finger. Empty: they play foci. */
    std::string finger = {};

    /** IPv4 of other computers whose commands are taken: touches and stops are taken from all. */
    std::vector<std::string> senders = {};
};

/** Limits the number in any second. */
class TouchRateLimit
{
public:
    using Time = std::chrono::steady_clock::time_point;

    explicit TouchRateLimit (int perSecondToAllow) : perSecond (perSecondToAllow) {}

    /** Whether one more may pass; if so, it has. Times do not go back. [any] */
    bool allows (Time now);

private:
    int perSecond;
    std::deque<Time> passed; ///< In the last second.
};

/** Where a message came from, and where its answers go. */
struct OscSender
{
    std::string address; ///< IPv4.
    int port = 0;

    bool operator<(const OscSender& other) const
    {
        return std::tie (address, port) < std::tie (other.address, other.port);
    }
};

struct OscAnswer
{
    OscSender to;
    OscMessage message;
};

/** What takes OSC commands and answers them; both are called on the receiver's thread. */
struct OscControl
{
    std::function<void (const OscMessage&, const OscSender&)> take;

    /** The answers that wait, of these commands or of what has happened since. */
    std::function<std::vector<OscAnswer>()> answers;
};

/** Listens for OSC and TUIO datagrams on a thread of its own and reports the touches. */
class TouchReceiver
{
public:
    /** Runs on the receiver's thread. Its exceptions are counted, not rethrown. Must not destroy the receiver. */
    using Callback = std::function<void (const Touch&)>;

    /** Opens the ports and starts the thread.
        @throws InputError where an address or a port is none or cannot be opened, as when another program has it
        [worker] */
    TouchReceiver (const TouchPorts&, const TouchOptions&, Callback, OscControl = {});

    /** Joins the thread, within 50 ms when the callback does not keep it. [worker] */
    ~TouchReceiver();
    TouchReceiver (const TouchReceiver&) = delete;
    TouchReceiver& operator= (const TouchReceiver&) = delete;

    /** Those that are open: the numbers in place of `anyFree`. [any] */
    const TouchPorts& ports() const { return openPorts; }

    /** Up to the last packet whose touches have all been reported. [any but the audio thread] */
    TouchCounters counters() const;

private:
    using Clock = std::chrono::steady_clock;

    int open (const char* name, int port);
    void run();
    void receive (juce::DatagramSocket&, std::vector<std::byte>& buffer);
    void forward (const Touch&);
    void take (const OscMessage&, const OscSender&);
    void answer();
    void publish();

    TouchPorts openPorts;
    Callback callback;
    std::vector<std::unique_ptr<juce::DatagramSocket>> sockets;
    TouchMessages messages;
    TouchRateLimit limit, commandLimit { 5000 };
    OscControl control;
    TouchCounters current; ///< Of the thread only, as the three before it once the thread runs.
    mutable std::mutex mutex;
    TouchCounters published; ///< Under the mutex.
    std::atomic<bool> isStopping { false };
    std::thread thread;
};
} // namespace antinode
