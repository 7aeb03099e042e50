#include "OscBytes.h"

#include <algorithm>

namespace antinode
{
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
} // namespace antinode
