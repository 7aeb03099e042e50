#include "WholeFile.h"

#include "InputError.h"
#include "MessageText.h"
#include "System.h"
#include "Watch.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace antinode
{
namespace
{
constexpr std::size_t longestPath = 300; ///< In a message, in bytes.

[[noreturn]] void refuse (const std::filesystem::path& path, const std::string& wrong)
{
    throw InputError (printable (path.string(), longestPath), wrong);
}

/** Of errno. */
[[noreturn]] void refuseUnreadable (const std::filesystem::path& path)
{
    refuse (path, std::string ("cannot be read: ") + std::strerror (errno));
}

[[noreturn]] void refuseTooLarge (const std::filesystem::path& path, std::uintmax_t maximumBytes)
{
    const auto mebibytes = maximumBytes >> 20, gibibytes = maximumBytes >> 30;
    refuse (path, "is too large; allowed: up to "
                      + (gibibytes > 0 ? std::to_string (gibibytes) + " GiB" : std::to_string (mebibytes) + " MiB"));
}

/** An open file, closed at the end. */
class OpenedFile
{
public:
    OpenedFile (const std::filesystem::path& pathToOpen, const FileKind& kind)
        : path (pathToOpen), descriptor (openForReading (path))
    {
        // ENXIO: a socket.
        if (descriptor < 0 && (errno == ENOENT || errno == ENOTDIR))
            refuse (path, kind.ifMissing);

        if (descriptor < 0 && errno != ENXIO)
            refuseUnreadable (path);

        const auto opened = descriptor < 0 ? std::nullopt : statusOf (descriptor);

        if (! opened || opened->isPipeOrSocket)
            refuseAndClose (std::string ("is a pipe or socket; allowed: ") + kind.name);

        if (opened->isFolder)
            refuseAndClose (std::string ("is a directory; allowed: ") + kind.name);

        status = *opened;
    }

    OpenedFile (const OpenedFile&) = delete;
    OpenedFile& operator= (const OpenedFile&) = delete;

    ~OpenedFile() { closeFile (descriptor); }

    /** What the system says; 0 of a device, and of files that it makes while they are read. */
    std::size_t size() const { return static_cast<std::size_t> (status.bytes); }

    bool isPlain() const { return status.isPlain; }

    /** The next bytes; 0 at the end. */
    std::size_t read (char* to, std::size_t count)
    {
        constexpr std::size_t maximumAtOnce = std::size_t { 1 } << 20; // between two looks at the watch
        checkWatch();
        const auto got = readBytes (descriptor, to, std::min (count, maximumAtOnce));

        if (got < 0)
            refuseUnreadable (path);

        return static_cast<std::size_t> (got);
    }

private:
    [[noreturn]] void refuseAndClose (const std::string& wrong) const
    {
        if (descriptor >= 0)
            closeFile (descriptor);

        refuse (path, wrong);
    }

    const std::filesystem::path& path;
    int descriptor;
    FileStatus status;
};
} // namespace

std::string readWholeFile (const std::filesystem::path& path, const FileKind& kind)
{
    constexpr std::size_t piece = std::size_t { 1 } << 16;
    constexpr std::uintmax_t deviceMaximum = std::uintmax_t { 64 } << 20;
    OpenedFile file (path, kind);
    const auto maximum = file.isPlain() ? kind.maximumBytes : std::min (kind.maximumBytes, deviceMaximum);

    if (file.size() > maximum)
        refuseTooLarge (path, maximum);

    // One byte more than it is said to have: the end shows without a second copy.
    std::string bytes (std::max (file.size() + 1, piece), '\0');
    std::size_t count = 0;

    while (const auto got = file.read (bytes.data() + count, bytes.size() - count))
    {
        count += got;

        if (count > maximum)
            refuseTooLarge (path, maximum);

        if (count == bytes.size())
            bytes.resize (2 * count);
    }

    bytes.resize (count);
    return bytes;
}
} // namespace antinode
