#include "OscPacket.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>
#include <type_traits>

namespace antinode
{
std::optional<double> toNumber (const OscArgument& argument)
{
    return std::visit (
        [] (const auto& value) -> std::optional<double>
        {
            using Value = std::decay_t<decltype (value)>;

            if constexpr (std::is_arithmetic_v<Value> && ! std::is_same_v<Value, bool>)
                return static_cast<double> (value);
            else
                return std::nullopt;
        },
        argument);
}

namespace
{
using Bytes = std::span<const std::byte>;
using Fault = std::optional<TouchFault>;

constexpr int deepest = 8;

std::optional<OscArgument> readArgument (char type, OscBytes& bytes)
{
    switch (type)
    {
        case 'i':
            return std::bit_cast<std::int32_t> (bytes.word());
        case 'f':
            return std::bit_cast<float> (bytes.word());
        case 's':
            return bytes.text();
        case 'b':
        {
            const auto blob = bytes.blob();
            return std::vector<std::byte> (blob.begin(), blob.end());
        }
        case 'h':
            return std::bit_cast<std::int64_t> (bytes.longWord());
        case 'd':
            return std::bit_cast<double> (bytes.longWord());
        case 'T':
        case 'F':
            return type == 'T';
        case 'N':
            return OscNil {};
        case 'I':
            return OscInfinitum {};
        case 't':
            return OscTimeTag { bytes.longWord() };
        default:
            return std::nullopt;
    }
}

constexpr std::array ending { OscPacket::stop, OscPacket::lift };

bool endsSomething (std::string_view address)
{
    return std::find (ending.begin(), ending.end(), address) != ending.end();
}

/** Whether an address stands anywhere in a packet that cannot be read: up to a byte that no address has. */
bool mentions (std::string_view packet, std::string_view address)
{
    constexpr auto endsOfAddresses = std::string_view ("\0 ,#", 4);

    for (auto at = packet.find (address); at != packet.npos; at = packet.find (address, at + 1))
        if (const auto end = at + address.size();
            end == packet.size() || endsOfAddresses.find (packet[end]) != endsOfAddresses.npos)
            return true;

    return false;
}

Fault readMessage (Bytes element, OscPacket& packet)
{
    OscBytes bytes (element);
    OscMessage message { bytes.text(), {} };

    // OSC 1.0 warns of older senders that leave the types out; where nothing follows there is nothing to guess.
    const auto types = bytes.left() == 0 ? "," : bytes.text();

    if (bytes.fault())
        return bytes.fault();

    if (! message.address.starts_with ('/') || ! types.starts_with (','))
        return TouchFault::malformed;

    for (const auto type : types.substr (1))
    {
        auto argument = readArgument (type, bytes);

        if (bytes.fault())
            return bytes.fault();

        if (! argument)
        {
            if (endsSomething (message.address))
                packet.messages.push_back ({ message.address, {} });
            else
                ++packet.unknownTypes;

            return std::nullopt;
        }

        message.arguments.push_back (std::move (*argument));
    }

    if (bytes.left() > 0)
        return TouchFault::malformed;

    packet.messages.push_back (std::move (message));
    return std::nullopt;
}

Fault readElement (Bytes element, int depth, OscPacket& packet);

Fault readBundle (Bytes element, int depth, OscPacket& packet)
{
    if (depth == deepest)
        return TouchFault::tooDeep;

    OscBytes bytes (element);
    const auto name = bytes.text();
    bytes.longWord(); // The time tag: touches are played when they come.

    if (! bytes.fault() && name != "#bundle")
        return TouchFault::malformed;

    while (bytes.left() > 0)
    {
        const auto part = bytes.take (bytes.word());

        if (bytes.fault())
            break;

        if (const auto fault = readElement (part, depth + 1, packet))
            return fault;
    }

    return bytes.fault();
}

Fault readElement (Bytes element, int depth, OscPacket& packet)
{
    if (element.size() % 4 != 0)
        return TouchFault::unaligned;

    if (! element.empty() && element.front() == std::byte { '#' })
        return readBundle (element, depth, packet);

    return readMessage (element, packet);
}
} // namespace

OscPacket readOscPacket (Bytes bytes)
{
    OscPacket packet;

    if (const auto fault = readElement (bytes, 0, packet))
    {
        packet = { {}, 0, fault };

        for (const auto address : ending)
            if (mentions ({ reinterpret_cast<const char*> (bytes.data()), bytes.size() }, address))
                packet.messages.push_back ({ std::string (address), {} });
    }

    return packet;
}

namespace
{
std::uint64_t bigEndian (std::span<const std::byte> field)
{
    std::uint64_t value = 0;

    for (const auto byte : field)
        value = value << 8 | std::to_integer<std::uint64_t> (byte);

    return value;
}
} // namespace

std::uint32_t OscBytes::word()
{
    return static_cast<std::uint32_t> (bigEndian (take (4)));
}

std::uint64_t OscBytes::longWord()
{
    return bigEndian (take (8));
}

std::string OscBytes::text()
{
    const auto end = std::find (bytes.begin(), bytes.end(), std::byte { 0 });

    if (end == bytes.end())
    {
        fail (TouchFault::truncated);
        return {};
    }

    const auto characters = takePadded (static_cast<std::size_t> (end - bytes.begin()) + 1);
    return { reinterpret_cast<const char*> (characters.data()), characters.empty() ? 0 : characters.size() - 1 };
}

std::span<const std::byte> OscBytes::blob()
{
    return takePadded (word());
}

std::span<const std::byte> OscBytes::take (std::size_t size)
{
    if (size > bytes.size())
        return fail (TouchFault::truncated);

    const auto taken = bytes.first (size);
    bytes = bytes.subspan (size);
    return taken;
}

std::span<const std::byte> OscBytes::takePadded (std::size_t size)
{
    const auto field = take (size);
    const auto padding = take ((4 - size % 4) % 4);

    if (std::any_of (padding.begin(), padding.end(), [] (std::byte byte) { return byte != std::byte { 0 }; }))
        return fail (TouchFault::malformed);

    return firstFault ? std::span<const std::byte> {} : field;
}

std::span<const std::byte> OscBytes::fail (TouchFault fault)
{
    if (! firstFault)
        firstFault = fault;

    bytes = {};
    return {};
}

namespace
{
/** Appends fields as OSC 1.0 has them. */
struct OscWriter
{
    std::string types = ",";
    std::vector<std::byte> bytes;

    void number (std::uint64_t value, int size)
    {
        for (auto shift = 8 * (size - 1); shift >= 0; shift -= 8)
            bytes.push_back (static_cast<std::byte> (value >> shift & 0xFFU));
    }

    void text (std::string_view value)
    {
        for (const auto character : value)
            bytes.push_back (static_cast<std::byte> (character));

        bytes.resize ((bytes.size() / 4 + 1) * 4);
    }

    void operator() (std::int32_t value) { add ('i', std::bit_cast<std::uint32_t> (value), 4); }
    void operator() (float value) { add ('f', std::bit_cast<std::uint32_t> (value), 4); }
    void operator() (std::int64_t value) { add ('h', std::bit_cast<std::uint64_t> (value), 8); }
    void operator() (double value) { add ('d', std::bit_cast<std::uint64_t> (value), 8); }
    void operator() (OscTimeTag value) { add ('t', value.value, 8); }
    void operator() (bool value) { types += value ? 'T' : 'F'; }
    void operator() (OscNil) { types += 'N'; }
    void operator() (OscInfinitum) { types += 'I'; }

    void operator() (const std::string& value)
    {
        types += 's';
        text (value.substr (0, value.find ('\0')));
    }

    void operator() (const std::vector<std::byte>& value)
    {
        types += 'b';
        number (value.size(), 4);
        bytes.insert (bytes.end(), value.begin(), value.end());
        bytes.resize ((bytes.size() + 3) / 4 * 4);
    }

private:
    void add (char type, std::uint64_t value, int size)
    {
        types += type;
        number (value, size);
    }
};
} // namespace

std::vector<std::byte> writeOscMessage (const OscMessage& message)
{
    OscWriter arguments, packet;

    for (const auto& argument : message.arguments)
        std::visit (arguments, argument);

    packet.text (message.address);
    packet.text (arguments.types);
    packet.bytes.insert (packet.bytes.end(), arguments.bytes.begin(), arguments.bytes.end());
    return std::move (packet.bytes);
}
} // namespace antinode
