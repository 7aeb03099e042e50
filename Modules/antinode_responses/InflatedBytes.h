#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace antinode
{
/** What zlib packed. Empty where it is damaged, or longer than this.
    @param most  bytes
    [worker] RFC 1950. */
std::optional<std::string> inflatedBytes (std::string_view packed, std::size_t most);
} // namespace antinode
