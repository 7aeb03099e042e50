#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace antinode
{
/** What an opened file is. */
struct FileStatus
{
    bool isPlain = false, isFolder = false, isPipeOrSocket = false;
    std::uintmax_t bytes = 0; ///< Of a plain file.
};

/** Opens a file for reading, bytes as they are, and waits for no pipe; programs that are started later do not have it.
    @return  a descriptor, or below 0: then errno says why, ENXIO of a socket [worker] */
int openForReading (const std::filesystem::path&);

/** What was opened: under its name there may be another file by now. None: errno says why. [worker] */
std::optional<FileStatus> statusOf (int descriptor);

/** Reads up to so many bytes, in spite of signals.
    @return  how many; 0 at the end; below 0: errno says why [worker] */
std::ptrdiff_t readBytes (int descriptor, char* to, std::size_t count);

/** [worker] */
void closeFile (int descriptor);
} // namespace antinode
