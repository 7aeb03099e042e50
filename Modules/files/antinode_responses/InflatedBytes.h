#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace antinode
{
/** Decompresses zlib data. Empty if it is damaged, or longer than this.
    @param maximum  bytes
    [worker] RFC 1950. */
std::optional<std::string> inflatedBytes (std::string_view packed, std::size_t maximum);
} // namespace antinode
