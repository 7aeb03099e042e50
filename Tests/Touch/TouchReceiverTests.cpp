#include "OscWriter.h"

#include <Support/ErrorText.h>

#include <antinode_touch/TouchReceiver.h>

#include <catch2/catch.hpp>

#include <chrono>

using namespace antinode;
using namespace std::string_literals;
using test::OscWriter;
using test::Packet;

namespace
{
constexpr TouchOptions options {};

TouchPorts freePorts()
{
    TouchPorts ports;
    ports.oscPort = ports.tuioPort = TouchPorts::anyFree;
    return ports;
}

/** Collects what comes; sends to a receiver and waits until it has read it all. */
class Listener
{
public:
    explicit Listener (TouchOptions touchOptions = {})
        : receiver (freePorts(), touchOptions,
                    [this] (const Touch& touch)
                    {
                        const std::lock_guard lock (mutex);
                        touches.push_back (touch);
                    })
    {
    }

    void send (int port, const Packet& packet)
    {
        // Loopback loses nothing while the buffer is not full.
        REQUIRE (sender.write ("127.0.0.1", port, packet.data(), static_cast<int> (packet.size()))
                 == static_cast<int> (packet.size()));
        ++sent;

        for (int i = 0; i < 5000 && receiver.counters().packets < sent; ++i)
            std::this_thread::sleep_for (std::chrono::milliseconds (1));

        REQUIRE (receiver.counters().packets == sent);
    }

    std::vector<Touch> heard()
    {
        const std::lock_guard lock (mutex);
        return touches;
    }

private:
    std::mutex mutex;
    std::vector<Touch> touches;
    juce::DatagramSocket sender;
    std::int64_t sent = 0;

public:
    TouchReceiver receiver; ///< The last: its thread uses the others.
};
} // namespace

TEST_CASE ("A datagram to the OSC port arrives as a touch", "[touch]")
{
    Listener listener;
    listener.send (listener.receiver.ports().oscPort, OscWriter::message ("/antinode/focus", 30, 40, 0.5F));
    REQUIRE (listener.heard().size() == 1);
    CHECK (listener.heard()[0] == Touch { TouchKind::focusAt, true, 30, 40, 0.5 });
    CHECK (listener.receiver.counters().touches == 1);
}

TEST_CASE ("A datagram to the TUIO port arrives as a touch, between others to the OSC port", "[touch]")
{
    Listener listener;
    const auto ports = listener.receiver.ports();
    CHECK (ports.oscPort != ports.tuioPort);
    listener.send (ports.oscPort, OscWriter::message ("/antinode/stop"));
    listener.send (ports.tuioPort,
                   OscWriter::bundle ({ OscWriter::message ("/tuio/2Dcur", "alive"s, 1),
                                        OscWriter::message ("/tuio/2Dcur", "set"s, 1, 0.5F, 0.25F, 0.0F, 0.0F, 0.0F),
                                        OscWriter::message ("/tuio/2Dcur", "fseq"s, 1) }));
    listener.send (ports.oscPort, OscWriter::message ("/antinode/focus", 1));
    REQUIRE (listener.heard().size() == 3);
    CHECK (listener.heard()[1] == Touch { TouchKind::focusAt, false, 0.5, 0.75, 1 });
}

TEST_CASE ("Bad datagrams, the empty one and the largest among them, are counted, and the next good one is heard",
           "[touch]")
{
    Listener listener;
    const auto port = listener.receiver.ports().oscPort;
    listener.send (port, {});
    listener.send (port, Packet (3));
    listener.send (port, Packet (65507, std::byte { 'x' })); // As large as UDP goes; no multiple of 4.
    listener.send (port, OscWriter::message ("/antinode/focus"));
    listener.send (port, OscWriter::message ("/antinode/focus", 1));
    const auto counters = listener.receiver.counters();
    CHECK (counters.of (TouchFault::truncated) == 1);
    CHECK (counters.of (TouchFault::unaligned) == 2);
    CHECK (counters.of (TouchFault::wrongArguments) == 1);
    CHECK (counters.touches == 1);
    CHECK (listener.heard().size() == 1);
}

TEST_CASE ("Too many touches are dropped and counted, stops never", "[touch]")
{
    Listener listener ({ 0, 2 });
    const auto focus = OscWriter::message ("/antinode/focus", 1);
    listener.send (listener.receiver.ports().oscPort,
                   OscWriter::bundle ({ focus, focus, focus, focus, focus, OscWriter::message ("/antinode/stop") }));
    const auto counters = listener.receiver.counters();
    CHECK (counters.touches == 3);
    CHECK (counters.limited == 3);
    CHECK (listener.heard().back().kind == TouchKind::stopAll);
}

TEST_CASE ("A callback that throws costs its touch and no more", "[touch]")
{
    std::atomic<int> calls { 0 };
    TouchReceiver receiver (freePorts(), options,
                            [&calls] (const Touch&)
                            {
                                ++calls;
                                throw std::runtime_error ("no");
                            });
    juce::DatagramSocket sender;
    const auto packet =
        OscWriter::bundle ({ OscWriter::message ("/antinode/stop"), OscWriter::message ("/antinode/stop") });
    sender.write ("127.0.0.1", receiver.ports().oscPort, packet.data(), static_cast<int> (packet.size()));

    for (int i = 0; i < 5000 && receiver.counters().packets == 0; ++i)
        std::this_thread::sleep_for (std::chrono::milliseconds (1));

    CHECK (receiver.counters().failures == 2);
    CHECK (calls == 2);
}

TEST_CASE ("A port that is taken, by a socket that allows reuse too, is an error in one sentence", "[touch]")
{
    juce::DatagramSocket other; // Allows reuse, as all of JUCE's do.
    REQUIRE (other.bindToPort (0, "127.0.0.1"));
    TouchPorts ports { other.getBoundPort(), 0, "127.0.0.1" };
    const auto number = std::to_string (ports.oscPort);
    const auto ignore = [] (const Touch&) {};
    CHECK (errorText ([&] { TouchReceiver (ports, options, ignore); })
           == "OSC port " + number + ": is in use by another program; allowed: a free port, or 0 for off");
    std::swap (ports.oscPort, ports.tuioPort);
    CHECK (errorText ([&] { TouchReceiver (ports, options, ignore); })
           == "TUIO port " + number + ": is in use by another program; allowed: a free port, or 0 for off");
}

TEST_CASE ("Ports and addresses that are none are errors in one sentence", "[touch]")
{
    const auto error = [] (const TouchPorts& ports)
    { return errorText ([&ports] { TouchReceiver (ports, options, [] (const Touch&) {}); }); };
    CHECK (error ({ 70000, 0, "127.0.0.1" }) == "Touch input: a port is 70000; allowed: 1 to 65535, or 0 for off");
    CHECK (error ({ 0, -2, "127.0.0.1" }) == "Touch input: a port is -2; allowed: 1 to 65535, or 0 for off");
    CHECK (error ({ 9000, 9000, "127.0.0.1" })
           == "Touch input: the OSC and the TUIO port are both 9000; allowed: two different ports");
    CHECK (error ({ 9000, 3333, "" })
           == "Touch input: the address is \"\"; allowed: an IPv4 address, for example 127.0.0.1");
    CHECK (error ({ 9000, 3333, "here" })
           == "Touch input: the address is \"here\"; allowed: an IPv4 address, for example 127.0.0.1");
    // 192.0.2.1 is for documentation (RFC 5737): no computer has it.
    CHECK (error ({ TouchPorts::anyFree, 0, "192.0.2.1" })
           == "OSC port: cannot be opened on 192.0.2.1: Cannot assign requested address");
}

TEST_CASE ("A receiver ends when it is not used any more, and its port is free again", "[touch]")
{
    auto ports = freePorts();
    ports.tuioPort = 0;

    for (int i = 0; i < 5; ++i)
    {
        const TouchReceiver receiver (ports, options, [] (const Touch&) {});
        CHECK (receiver.ports().tuioPort == 0);
        ports.oscPort = receiver.ports().oscPort;
    }
}

TEST_CASE ("A receiver without ports hears nothing and ends", "[touch]")
{
    const TouchReceiver receiver ({ 0, 0, "127.0.0.1" }, options, [] (const Touch&) {});
    CHECK (receiver.counters().packets == 0);
}
