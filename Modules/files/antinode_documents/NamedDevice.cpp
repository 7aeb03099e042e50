#include "NamedDevice.h"

namespace antinode
{
std::string readNamedDevice (const std::optional<JsonValue>& device)
{
    constexpr std::size_t longestPath = 4000; // bytes

    if (! device)
        return {};

    auto name = device->text (longestPath);

    if (name.empty())
        device->fail ("is empty; allowed: the name of a device, or a file that ends in .json");

    return name;
}
} // namespace antinode
