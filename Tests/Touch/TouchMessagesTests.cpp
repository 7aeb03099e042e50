#include "OscWriter.h"

#include <antinode_touch/TouchMessages.h>
#include <antinode_touch/TouchReceiver.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

using namespace antinode;
using namespace std::string_view_literals;
using test::OscWriter;
using test::Packet;
using test::toPacket;

namespace
{
struct Reading
{
    std::vector<Touch> touches;
    TouchCounters counters;
};

Reading read (const Packet& packet)
{
    Reading reading;
    reading.touches = TouchMessages().read (packet, {}, reading.counters);
    CHECK (reading.counters.packets == 1);
    return reading;
}

/** Of a packet that gives no touch: its only fault. */
TouchFault onlyFault (const Packet& packet)
{
    const auto reading = read (packet);
    CHECK (reading.touches.empty());
    const auto& faults = reading.counters.faults;
    REQUIRE (std::count (faults.begin(), faults.end(), 1) == 1);
    REQUIRE (std::count (faults.begin(), faults.end(), 0) == static_cast<int> (faults.size()) - 1);
    return static_cast<TouchFault> (std::find (faults.begin(), faults.end(), 1) - faults.begin());
}

constexpr auto infinite = std::numeric_limits<float>::infinity();
constexpr auto notANumber = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST_CASE ("A focus is asked for in millimetres, to the byte", "[touch]")
{
    const auto reading =
        read (toPacket ("/antinode/focus\0,fff\0\0\0\0\x42\x94\x00\x00\xc2\xd2\x00\x00\x3f\x00\x00\x00"sv));
    REQUIRE (reading.touches.size() == 1);
    CHECK (reading.touches[0] == Touch { TouchKind::focusAt, true, 74, -105, 0.5 });
}

TEST_CASE ("On a beam y is left out, without an amplitude it is 1, integers and doubles are numbers", "[touch]")
{
    CHECK (read (OscWriter::message ("/antinode/focus", 30)).touches[0]
           == Touch { TouchKind::focusAt, true, 30, 0, 1 });
    CHECK (read (OscWriter::message ("/antinode/focus", 30.25, std::int64_t { 40 })).touches[0]
           == Touch { TouchKind::focusAt, true, 30.25, 40, 1 });
}

TEST_CASE ("A touch is asked for in fractions of the surface, its edges included", "[touch]")
{
    CHECK (read (OscWriter::message ("/antinode/touch", 0.25, 1.0, 0.75)).touches[0]
           == Touch { TouchKind::focusAt, false, 0.25, 1, 0.75 });
    CHECK (read (OscWriter::message ("/antinode/touch", 0, 1)).touches[0]
           == Touch { TouchKind::focusAt, false, 0, 1, 1 });
    CHECK (onlyFault (OscWriter::message ("/antinode/touch", 1.0001, 0.5)) == TouchFault::outside);
    CHECK (onlyFault (OscWriter::message ("/antinode/touch", 0.5, -0.0001)) == TouchFault::outside);
}

TEST_CASE ("Amplitudes are clamped to 0 to 1", "[touch]")
{
    CHECK (read (OscWriter::message ("/antinode/focus", 1, 1, 127)).touches[0].amplitude == 1);
    CHECK (read (OscWriter::message ("/antinode/focus", 1, 1, -0.5)).touches[0].amplitude == 0);
}

TEST_CASE ("A stop stops, whatever stands behind it: buttons send their state", "[touch]")
{
    CHECK (read (toPacket ("/antinode/stop\0\0,\0\0\0"sv)).touches.at (0).kind == TouchKind::stopAll);
    CHECK (read (toPacket ("/antinode/stop\0\0"sv)).touches.at (0).kind == TouchKind::stopAll);
    CHECK (read (OscWriter::message ("/antinode/stop", 0.0F)).touches.at (0).kind == TouchKind::stopAll);
}

TEST_CASE ("A stop stops, whatever is wrong with its types, its padding or the packet around it", "[touch]")
{
    const auto stops = [] (const Packet& packet)
    {
        const auto touches = read (packet).touches;
        return touches.size() == 1 && touches[0].kind == TouchKind::stopAll;
    };
    const auto plain = toPacket ("/antinode/stop\0\0,\0\0\0"sv), focus = OscWriter::message ("/antinode/focus", 1);
    CHECK (stops (toPacket ("/antinode/stop\0\0,S\0\0now\0"sv))); // A type that is not read.
    CHECK (stops (toPacket ("/antinode/stop\0\0,[i]\0\0\0\0\0\0\0\1"sv)));
    CHECK (stops (toPacket ("/antinode/stop\0\0,f\0\0"sv)));          // Its number is missing,
    CHECK (stops (toPacket ("/antinode/stop\0\0,\0\0\0\0\0\0\1"sv))); // one is left over,
    CHECK (stops (toPacket ("/antinode/stop\0\0f\0\0\0"sv)));         // types without a comma,
    CHECK (stops (toPacket ("/antinode/stop\0x,\0\0\0"sv)));          // padding,
    CHECK (stops (toPacket ("/antinode/stop\0,\0"sv)));               // none,
    CHECK (stops (toPacket ("/antinode/stop"sv)));                    // no end at all.
    CHECK (stops (OscWriter::bundle ({ plain, toPacket ("/a\0x,\0\0\0"sv) })));
    CHECK (stops (OscWriter::bundle ({ toPacket ("/a\0x,\0\0\0"sv), plain, focus })));
    CHECK (stops (OscWriter::bundle ({ toPacket ("odd"sv), plain })));

    auto cut = OscWriter::bundle ({ focus, plain, focus });
    cut.resize (cut.size() - 9);
    CHECK (stops (cut));
    auto deep = plain;

    for (int depth = 0; depth < 9; ++depth)
        deep = OscWriter::bundle ({ deep });

    CHECK (stops (deep));

    // In its place among others where the packet can be read; other addresses are others.
    const auto unread = toPacket ("/antinode/stop\0\0,S\0\0now\0"sv);
    const auto touches = read (OscWriter::bundle ({ focus, unread, focus })).touches;
    REQUIRE (touches.size() == 3);
    CHECK (touches[1].kind == TouchKind::stopAll);
    CHECK (onlyFault (toPacket ("/antinode/stopped\0\0\0,f\0\0"sv)) == TouchFault::truncated);
    CHECK (onlyFault (toPacket ("/antinode/stop/not\0\0,f\0\0"sv)) == TouchFault::truncated);
}

TEST_CASE ("Wrong arguments, numbers that are not finite and unknown addresses are dropped and counted", "[touch]")
{
    CHECK (onlyFault (OscWriter::message ("/antinode/focus")) == TouchFault::wrongArguments);
    CHECK (onlyFault (OscWriter::message ("/antinode/focus", 1, 2, 1, 4)) == TouchFault::wrongArguments);
    CHECK (onlyFault (OscWriter::message ("/antinode/focus", 1, std::string ("2"))) == TouchFault::wrongArguments);
    CHECK (onlyFault (toPacket ("/antinode/focus\0,T\0\0"sv)) == TouchFault::wrongArguments);
    CHECK (onlyFault (OscWriter::message ("/antinode/touch", 0.5)) == TouchFault::wrongArguments);
    CHECK (onlyFault (OscWriter::message ("/antinode/focus", infinite, 1)) == TouchFault::notFinite);
    CHECK (onlyFault (OscWriter::message ("/antinode/focus", 1, notANumber)) == TouchFault::notFinite);
    CHECK (onlyFault (OscWriter::message ("/antinode/focus", 1, 1, notANumber)) == TouchFault::notFinite);
    CHECK (onlyFault (OscWriter::message ("/antinode/touch", notANumber, 1)) == TouchFault::notFinite);
    CHECK (onlyFault (OscWriter::message ("/antinode/focuses", 1)) == TouchFault::unknownAddress);
    CHECK (onlyFault (OscWriter::message ("/antinode/*", 1)) == TouchFault::unknownAddress);
    CHECK (onlyFault (toPacket ("/antinode/focus\0,r\0\0\0\0\0\0"sv)) == TouchFault::unknownType);
    CHECK (onlyFault (toPacket ("/antinode/focus\0,f\0\0"sv)) == TouchFault::truncated);
}

TEST_CASE ("A bundle gives all its touches in their order, and a bad message costs only itself", "[touch]")
{
    const auto reading = read (
        OscWriter::bundle ({ OscWriter::message ("/antinode/stop"), OscWriter::message ("/antinode/touch", 7, 7),
                             OscWriter::message ("/antinode/focus", 1), OscWriter::message ("/antinode/focus", 2) }));
    REQUIRE (reading.touches.size() == 3);
    CHECK (reading.touches[0].kind == TouchKind::stopAll);
    CHECK (reading.touches[1].x == 1);
    CHECK (reading.touches[2].x == 2);
    CHECK (reading.counters.of (TouchFault::outside) == 1);
}

TEST_CASE ("No second holds more touches than the limit", "[touch]")
{
    using namespace std::chrono_literals;
    TouchRateLimit limit (3);
    const TouchRateLimit::Time start {};

    for (int i = 0; i < 3; ++i)
        CHECK (limit.allows (start + i * 100ms));

    CHECK_FALSE (limit.allows (start + 300ms));
    CHECK_FALSE (limit.allows (start + 999ms));
    CHECK (limit.allows (start + 1000ms));       // The first is a second ago,
    CHECK_FALSE (limit.allows (start + 1099ms)); // the second is not yet.
    CHECK (limit.allows (start + 1100ms));
    CHECK_FALSE (TouchRateLimit (0).allows (start));
}

TEST_CASE ("OSC puts fingers down by numbers and lifts one or all of them", "[touch]")
{
    TouchMessages messages;
    TouchCounters counters;
    const auto read = [&] (const auto& packet) { return messages.read (packet, {}, counters); };
    const auto down = read (OscWriter::message ("/antinode/finger", std::int32_t { 1 }, 0.25F, 0.5F));
    REQUIRE (down.size() == 1);
    CHECK (down[0] == Touch { TouchKind::rest, false, 0.25, 0.5, 1, 1 });
    read (OscWriter::message ("/antinode/finger", std::int32_t { 4 }, 0.75F, 0.5F));
    const auto up = read (OscWriter::message ("/antinode/lift", std::int32_t { 1 }));
    REQUIRE (up.size() == 1);
    CHECK (up[0].kind == TouchKind::lift);
    CHECK (up[0].finger == 1);
    const auto all = read (OscWriter::message ("/antinode/lift"));
    REQUIRE (all.size() == 1);
    CHECK (all[0].finger == 4);

    CHECK (read (OscWriter::message ("/antinode/finger", 1.5F, 0.25F, 0.5F)).empty());
    CHECK (read (OscWriter::message ("/antinode/finger", std::int32_t { 1 }, 0.25F)).empty());
    CHECK (counters.of (TouchFault::wrongArguments) == 2);

    // A lift that does not say which lifts all: rather one too many than one too few.
    read (OscWriter::message ("/antinode/finger", std::int32_t { 2 }, 0.25F, 0.5F));
    CHECK (read (OscWriter::message ("/antinode/lift", std::int32_t { -1 })).size() == 1);
    CHECK (counters.of (TouchFault::wrongArguments) == 3);
    read (OscWriter::message ("/antinode/finger", std::int32_t { 2 }, 0.25F, 0.5F));
    CHECK (read (toPacket ("/antinode/lift\0\0,S\0\0two\0"sv)).size() == 1);
    CHECK (counters.of (TouchFault::unknownType) == 0);
    CHECK (read (OscWriter::message ("/antinode/finger", std::int32_t { 1 }, 1.25F, 0.5F)).empty());
    CHECK (counters.of (TouchFault::outside) == 1);
}

TEST_CASE ("Commands keep their order among touches, and are unknown where nobody takes them", "[touch][osc]")
{
    using namespace std::string_literals;
    const auto packet =
        OscWriter::bundle ({ OscWriter::message ("/antinode/play", "left"s),
                             OscWriter::message ("/antinode/focus", 1.0F), OscWriter::message ("/antinode/stop"),
                             OscWriter::message ("/antinode/play", "right"s), OscWriter::message ("/other/program") });
    TouchMessages messages;
    TouchCounters counters;
    std::vector<OscCommand> commands;
    const auto touches = messages.read (packet, {}, counters, &commands);
    REQUIRE (touches.size() == 2);
    REQUIRE (commands.size() == 3);
    CHECK (commands[0].touchesBefore == 0);
    CHECK (commands[1].message.address == "/antinode/stop"); // Answered, too.
    CHECK (commands[2].touchesBefore == 2);
    CHECK (counters.of (TouchFault::unknownAddress) == 1);
    messages.read (packet, {}, counters);
    CHECK (counters.of (TouchFault::unknownAddress) == 4);
}
