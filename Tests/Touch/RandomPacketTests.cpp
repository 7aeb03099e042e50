#include "OscWriter.h"

#include <antinode_touch/OscPacket.h>
#include <antinode_touch/TouchMessages.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace antinode;
using namespace std::string_literals;
using test::OscWriter;
using test::Packet;

namespace
{
using Random = std::mt19937;

std::size_t below (Random& random, std::size_t bound)
{
    return random() % bound;
}

std::byte anyByte (Random& random)
{
    return static_cast<std::byte> (random() & 0xff);
}

std::vector<Packet> goodPackets()
{
    const auto tuio = [] (auto... arguments) { return OscWriter::message ("/tuio/2Dcur", arguments...); };
    const auto frame = OscWriter::bundle ({ tuio ("source"s, "a@b"s), tuio ("alive"s, 1, 2, 3),
                                            tuio ("set"s, 1, 0.1F, 0.2F, 0.0F, 0.0F, 0.0F),
                                            tuio ("set"s, 3, 0.5F, 0.9F, 0.0F, 0.0F, 0.0F), tuio ("fseq"s, 7) });
    return { OscWriter::message ("/antinode/focus", 10.0F, 20, 0.5),
             OscWriter::message ("/antinode/touch", 0.5, std::int64_t { 1 }),
             OscWriter::message ("/antinode/stop"),
             OscWriter::message ("/other", "text"s),
             frame,
             OscWriter::bundle ({ OscWriter::bundle ({ frame }), OscWriter::message ("/antinode/focus", 1) }) };
}

/** Sizes, tags and numbers that lie at the edges of what a reader may assume. */
void writeExtreme (Packet& packet, Random& random)
{
    constexpr std::array<std::uint32_t, 10> words { 0,          1,          4,          0x7fffffff, 0x80000000,
                                                    0xffffffff, 0xfffffffc, 0x7f800000, 0x7fc00000, 0x2c736962 };

    if (packet.size() < 4)
        return;

    const auto word = words[below (random, words.size())];
    const auto at = below (random, packet.size() / 4) * 4;

    for (std::size_t i = 0; i < 4; ++i)
        packet[at + i] = static_cast<std::byte> (word >> (24 - 8 * i) & 0xff);
}

void mutate (Packet& packet, const std::vector<Packet>& others, Random& random)
{
    const auto at = packet.empty() ? 0 : below (random, packet.size());

    switch (random() % 7)
    {
        case 0:
            packet.resize (at);
            break;
        case 1:
            packet.resize (at / 4 * 4);
            break;
        case 2:
            std::generate_n (std::back_inserter (packet), below (random, 9), [&random] { return anyByte (random); });
            break;
        case 3:
            writeExtreme (packet, random);
            break;
        case 4:
        {
            const auto& other = others[below (random, others.size())];
            packet.insert (packet.begin() + static_cast<std::ptrdiff_t> (at / 4 * 4), other.begin(), other.end());
            break;
        }
        case 5:
            for (auto depth = below (random, 10); depth > 0; --depth)
                packet = OscWriter::bundle ({ packet });

            break;
        default:
            if (! packet.empty())
                packet[at] ^= static_cast<std::byte> (1 << random() % 8);
    }
}

Packet randomPacket (const std::vector<Packet>& good, Random& random)
{
    Packet packet;

    if (random() % 8 == 0)
        std::generate_n (std::back_inserter (packet), below (random, 200), [&random] { return anyByte (random); });
    else
        packet = good[below (random, good.size())];

    for (auto count = below (random, 5); count > 0; --count)
        mutate (packet, good, random);

    return packet;
}

bool isGood (const Touch& touch)
{
    const auto isFraction = [] (double value) { return value >= 0 && value <= 1; };
    return std::isfinite (touch.x) && std::isfinite (touch.y) && isFraction (touch.amplitude)
           && (touch.inMillimetres || (isFraction (touch.x) && isFraction (touch.y)));
}
} // namespace

TEST_CASE ("100 000 random and mutated packets give good touches or counted faults and nothing else", "[touch][fuzz]")
{
    Random random (20180618);
    const auto good = goodPackets();
    TouchMessages messages ({ 0.01, 500 });
    TouchCounters counters;
    std::int64_t touches = 0, bad = 0;

    for (int i = 0; i < 100000; ++i)
    {
        // Of the exact size on the heap: the address sanitizer sees a read of one byte too many.
        auto packet = randomPacket (good, random);
        packet.shrink_to_fit();
        const auto found = messages.read (packet, {}, counters);
        touches += static_cast<std::int64_t> (found.size());

        if (! std::all_of (found.begin(), found.end(), isGood))
            ++bad;

        // No argument without a byte for its type.
        for (const auto& message : readOscPacket (packet).messages)
            if (message.arguments.size() > packet.size())
                ++bad;
    }

    CHECK (bad == 0);
    CHECK (counters.packets == 100000);
    CHECK (touches > 1000);

    for (const auto count : counters.faults)
        CHECK (count > 0); // Every kind of fault was met: the packets are mean enough.

    CHECK (messages.read (good[0], {}, counters).size() == 1);
}
