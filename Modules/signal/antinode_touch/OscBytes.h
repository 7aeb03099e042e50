#pragma once

#include "TouchFault.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace antinode
{
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
