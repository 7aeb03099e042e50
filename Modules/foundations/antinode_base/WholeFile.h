#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
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

/** What a reader of a file accepts, and how its errors say so. */
struct FileKind
{
    const char* name = "a file"; ///< For "is a directory; allowed: a JSON file".
    std::uintmax_t maximumBytes = std::uintmax_t { 64 } << 20;
    const char* ifMissing = "does not exist";
};

/** All bytes of a file. A pipe is never waited for; of a device without end no more is read than a file may have.
    @throws InputError  with the path: when it is missing, a directory, a pipe or socket, unreadable, or too large
    [worker] */
std::string readWholeFile (const std::filesystem::path&, const FileKind&);
} // namespace antinode
