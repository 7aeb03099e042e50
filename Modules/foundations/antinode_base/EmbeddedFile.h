#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace antinode
{
/** A file that was compiled into the program. */
struct EmbeddedFile
{
    const char* name;  ///< Path inside its folder, for example "Devices/staple.json".
    const char* begin; ///< First byte.
    const char* end;   ///< One past the last byte.

    /** The content as text. [any] */
    std::string_view text() const { return { begin, static_cast<std::size_t> (end - begin) }; }
};
} // namespace antinode
