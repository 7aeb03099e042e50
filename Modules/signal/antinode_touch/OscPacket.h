#pragma once

#include "Touch.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace antinode
{
struct OscNil
{
    bool operator== (const OscNil&) const = default;
};

struct OscInfinitum
{
    bool operator== (const OscInfinitum&) const = default;
};

/** Seconds since 1900, with 32 binary places; 1 = at once. */
struct OscTimeTag
{
    std::uint64_t value = 1;

    bool operator== (const OscTimeTag&) const = default;
};

/** The types i f s b h d T F N I t. */
using OscArgument = std::variant<std::int32_t, float, std::string, std::vector<std::byte>, std::int64_t, double, bool,
                                 OscNil, OscInfinitum, OscTimeTag>;

struct OscMessage
{
    std::string address; ///< Starts with '/'.
    std::vector<OscArgument> arguments;
};

/** An argument of the types i f h d as a number; may be not finite. [any] */
std::optional<double> toNumber (const OscArgument&);

/** The content of an OSC 1.0 datagram. */
struct OscPacket
{
    std::vector<OscMessage> messages; ///< In their order; bundles are laid open, their time tags left out.
    int unknownTypes = 0;             ///< Messages with types that are not read: left out, as OSC 1.0 asks.
    std::optional<TouchFault> fault;  ///< Of the packet as a whole: then there are no messages.

    // Of these addresses a message is one, without arguments, whatever is wrong with it or with the packet.
    static constexpr std::string_view stop = "/antinode/stop", lift = "/antinode/lift";
};

/** Reads a message, or bundles in each other, to 8 deep. Claimed sizes are checked before they are used: memory is
    bounded by the size of the packet. [any] */
OscPacket readOscPacket (std::span<const std::byte> packet);

/** A datagram of one message. [any] */
std::vector<std::byte> writeOscMessage (const OscMessage&);

/** Takes the fields of OSC 1.0 off the front of some bytes: big-endian, each a multiple of 4 long. After the first
    fault nothing is left and every field is zero or empty, so that only the end of a series need be checked. */
class OscBytes
{
public:
    /** @param bytesToRead  outlive this. [any] as all that follows */
    explicit OscBytes (std::span<const std::byte> bytesToRead) : bytes (bytesToRead) {}

    std::size_t left() const { return bytes.size(); }
    std::optional<TouchFault> fault() const { return firstFault; }

    std::uint32_t word();
    std::uint64_t longWord();

    /** A string without its zeros. */
    std::string text();

    /** A size as a word, as many bytes, zeros. */
    std::span<const std::byte> blob();

    /** Bytes without padding: the contents of an element. */
    std::span<const std::byte> take (std::size_t size);

private:
    std::span<const std::byte> takePadded (std::size_t size);
    std::span<const std::byte> fail (TouchFault);

    std::span<const std::byte> bytes;
    std::optional<TouchFault> firstFault;
};
} // namespace antinode
