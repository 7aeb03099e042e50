#ifndef _WIN32

#include "Processes.h"
#include "SystemFiles.h"

#include <array>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace antinode
{
int openForReading (const std::filesystem::path& path)
{
    return open (path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
}

std::optional<FileStatus> statusOf (int descriptor)
{
    struct stat status
    {
    };

    if (fstat (descriptor, &status) != 0)
        return std::nullopt;

    const bool isPlain = S_ISREG (status.st_mode);
    return FileStatus { isPlain, S_ISDIR (status.st_mode), S_ISFIFO (status.st_mode) || S_ISSOCK (status.st_mode),
                        isPlain ? static_cast<std::uintmax_t> (status.st_size) : 0 };
}

std::ptrdiff_t readBytes (int descriptor, char* to, std::size_t count)
{
    auto got = read (descriptor, to, count);

    while (got < 0 && errno == EINTR)
        got = read (descriptor, to, count);

    return got;
}

void closeFile (int descriptor)
{
    close (descriptor);
}

int ownProcess()
{
    return getpid();
}

bool isProcessRunning (int process)
{
    return kill (process, 0) == 0 || errno != ESRCH;
}

std::string computerName()
{
    constexpr std::size_t longest = 256;
    std::array<char, longest> name {};
    return gethostname (name.data(), name.size() - 1) == 0 ? name.data() : "";
}
} // namespace antinode

#endif
