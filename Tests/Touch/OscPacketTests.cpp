#include "OscWriter.h"

#include <antinode_touch/OscPacket.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace std::string_view_literals;
using test::OscWriter;
using test::Packet;
using test::toPacket;

namespace
{
template <typename Value>
Value argument (const OscPacket& packet, std::size_t index)
{
    REQUIRE (packet.messages.size() == 1);
    return std::get<Value> (packet.messages[0].arguments.at (index));
}

std::optional<TouchFault> findFault (std::string_view text)
{
    const auto packet = readOscPacket (toPacket (text));

    if (packet.fault)
        CHECK (packet.messages.empty());

    return packet.fault;
}
} // namespace

// The examples of the specification: https://opensoundcontrol.stanford.edu/spec-1_0-examples.html
TEST_CASE ("The first example of the OSC 1.0 specification: a frequency of 440", "[touch]")
{
    const auto packet = readOscPacket (toPacket ("/oscillator/4/frequency\0,f\0\0\x43\xdc\x00\x00"sv));
    CHECK_FALSE (packet.fault);
    CHECK (argument<float> (packet, 0) == 440.0F);
    CHECK (packet.messages[0].address == "/oscillator/4/frequency");
    CHECK (packet.messages[0].arguments.size() == 1);
}

TEST_CASE ("The second example of the OSC 1.0 specification: integers, a string and floats", "[touch]")
{
    const auto packet = readOscPacket (toPacket ("/foo\0\0\0\0,iisff\0\0\x00\x00\x03\xe8\xff\xff\xff\xff"
                                                 "hello\0\0\0\x3f\x9d\xf3\xb6\x40\xb5\xb2\x2d"sv));
    CHECK_FALSE (packet.fault);
    CHECK (argument<std::int32_t> (packet, 0) == 1000);
    CHECK (argument<std::int32_t> (packet, 1) == -1);
    CHECK (argument<std::string> (packet, 2) == "hello");
    CHECK (argument<float> (packet, 3) == 1.234F);
    CHECK (argument<float> (packet, 4) == 5.678F);
}

TEST_CASE ("The types of OSC 1.0 that have 8 bytes, none, or as many as they say", "[touch]")
{
    const auto packet = readOscPacket (toPacket ("/a\0\0,hdtTFNIb\0\0\0\x00\x00\x00\x00\x00\x00\x00\x02"
                                                 "\x3f\xf8\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01"
                                                 "\x00\x00\x00\x05\x01\x02\x03\x04\x05\0\0\0"sv));
    CHECK_FALSE (packet.fault);
    CHECK (argument<std::int64_t> (packet, 0) == 2);
    CHECK (argument<double> (packet, 1) == 1.5);
    CHECK (argument<OscTimeTag> (packet, 2).value == 1);
    CHECK (argument<bool> (packet, 3));
    CHECK_FALSE (argument<bool> (packet, 4));
    CHECK (std::holds_alternative<OscNil> (packet.messages[0].arguments[5]));
    CHECK (std::holds_alternative<OscInfinitum> (packet.messages[0].arguments[6]));
    CHECK (argument<std::vector<std::byte>> (packet, 7) == toPacket ("\1\2\3\4\5"));
}

TEST_CASE ("A bundle gives the messages of its elements and of the bundles in it, in their order", "[touch]")
{
    const auto packet = readOscPacket (toPacket ("#bundle\0\x00\x00\x00\x00\x00\x00\x00\x01"
                                                 "\x00\x00\x00\x08/a\0\0,\0\0\0"
                                                 "\x00\x00\x00\x1c#bundle\0\x00\x00\x00\x00\x00\x00\x00\x01"
                                                 "\x00\x00\x00\x08/b\0\0,\0\0\0"
                                                 "\x00\x00\x00\x08/c\0\0,\0\0\0"sv));
    CHECK_FALSE (packet.fault);
    REQUIRE (packet.messages.size() == 3);
    CHECK (packet.messages[0].address == "/a");
    CHECK (packet.messages[1].address == "/b");
    CHECK (packet.messages[2].address == "/c");
    CHECK_FALSE (findFault ("#bundle\0\x00\x00\x00\x00\x00\x00\x00\x01"sv)); // No elements: a bundle all the same.
}

TEST_CASE ("Strings and blobs of every length are padded to multiples of 4", "[touch]")
{
    for (std::size_t length = 0; length < 9; ++length)
    {
        const std::string text (length, 'x');
        const auto packet = readOscPacket (OscWriter::message ("/a", text, std::int32_t { 7 }));
        CHECK (argument<std::string> (packet, 0) == text);
        CHECK (argument<std::int32_t> (packet, 1) == 7);
    }
}

TEST_CASE ("Bundles are read 8 deep and no deeper", "[touch]")
{
    auto packet = OscWriter::message ("/a");

    for (int depth = 0; depth < 8; ++depth)
        packet = OscWriter::bundle ({ packet });

    CHECK (readOscPacket (packet).messages.size() == 1);
    CHECK (readOscPacket (OscWriter::bundle ({ packet })).fault == TouchFault::tooDeep);
}

TEST_CASE ("A message without types, as of old senders, has no arguments", "[touch]")
{
    const auto packet = readOscPacket (toPacket ("/antinode/stop\0\0"sv));
    REQUIRE (packet.messages.size() == 1);
    CHECK (packet.messages[0].arguments.empty());
    CHECK (findFault ("/a\0\0\x43\xdc\x00\x00"sv) == TouchFault::malformed);
}

TEST_CASE ("A message of a type that is not read is left out, the others of its bundle stay", "[touch]")
{
    const auto unknown = toPacket ("/a\0\0,c\0\0\0\0\0x"sv);
    const auto packet = readOscPacket (OscWriter::bundle ({ unknown, OscWriter::message ("/b", 1.0F) }));
    CHECK_FALSE (packet.fault);
    CHECK (packet.unknownTypes == 1);
    REQUIRE (packet.messages.size() == 1);
    CHECK (packet.messages[0].address == "/b");
}

TEST_CASE ("What is cut off, unaligned or malformed is said to be so", "[touch]")
{
    CHECK (findFault (""sv) == TouchFault::truncated);
    CHECK (findFault ("/abc"sv) == TouchFault::truncated);                 // No zero.
    CHECK (findFault ("/a\0\0,f\0\0"sv) == TouchFault::truncated);         // No float.
    CHECK (findFault ("/a\0\0,d\0\0\0\0\0\0"sv) == TouchFault::truncated); // Half a double.
    CHECK (findFault ("/a\0\0,s\0\0abcd"sv) == TouchFault::truncated);
    CHECK (findFault ("/a\0\0,b\0\0\x7f\xff\xff\xff"sv) == TouchFault::truncated); // 2 GiB that are not there.
    CHECK (findFault ("/a\0\0,b\0\0\xff\xff\xff\xff"sv) == TouchFault::truncated); // A negative size.
    CHECK (findFault ("/a\0\0,b\0\0\xff\xff\xff\xfd"
                      "abcd"sv)
           == TouchFault::truncated); // Overflows when padded.
    CHECK (findFault ("#bundle\0\0\0\0\0"sv) == TouchFault::truncated);
    CHECK (findFault ("#bundle\0\0\0\0\0\0\0\0\1\0\0\0\x0c/a\0\0,\0\0\0"sv) == TouchFault::truncated);
    CHECK (findFault ("#bundle\0\0\0\0\0\0\0\0\1\0\0\0\0"sv) == TouchFault::truncated); // An element of nothing.
    CHECK (findFault ("/a\0\0,\0\0"sv) == TouchFault::unaligned);
    CHECK (findFault ("#bundle\0\0\0\0\0\0\0\0\1\0\0\0\6/a\0\0,\0\0\0"sv) == TouchFault::unaligned);
    CHECK (findFault ("abc\0,\0\0\0"sv) == TouchFault::malformed);          // No address.
    CHECK (findFault ("/a\0\0f\0\0\0\0\0\0\0"sv) == TouchFault::malformed); // Types without their comma.
    CHECK (findFault ("/a\0x,\0\0\0"sv) == TouchFault::malformed);          // Padding.
    CHECK (findFault ("/a\0\0,\0\0\0\0\0\0\0"sv) == TouchFault::malformed); // Bytes left over.
    CHECK (findFault ("#bandle\0\0\0\0\0\0\0\0\1"sv) == TouchFault::malformed);
}

TEST_CASE ("A fault anywhere in a packet drops all of it", "[touch]")
{
    const auto good = OscWriter::message ("/a");
    const auto packet = readOscPacket (OscWriter::bundle ({ good, toPacket ("/a\0x,\0\0\0"sv), good }));
    CHECK (packet.fault == TouchFault::malformed);
    CHECK (packet.messages.empty());
}

TEST_CASE ("What is written is what another writer writes, and reads back", "[touch][osc]")
{
    using namespace std::string_literals;
    const OscMessage message { "/antinode/designed",
                               { "#1"s, std::int32_t { -7 }, 2.5F, std::int64_t { 1 } << 40, -0.125, "four"s } };
    const auto written = writeOscMessage (message);
    CHECK (written
           == test::OscWriter::message ("/antinode/designed", "#1"s, std::int32_t { -7 }, 2.5F,
                                        std::int64_t { 1 } << 40, -0.125, "four"s));
    const auto read = readOscPacket (written);
    REQUIRE (read.messages.size() == 1);
    CHECK (read.messages[0].address == message.address);
    CHECK (read.messages[0].arguments == message.arguments);
    const OscMessage others { "/a",
                              { true, false, OscNil {}, OscInfinitum {}, OscTimeTag { 5 },
                                std::vector<std::byte> { std::byte { 1 }, std::byte { 2 } } } };
    CHECK (readOscPacket (writeOscMessage (others)).messages.at (0).arguments == others.arguments);
}
