#ifndef _WIN32

#include "System.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include <arpa/inet.h>
#include <fcntl.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace antinode
{
namespace
{
void handle (int signal, void (*handler) (int))
{
    struct sigaction action = {};
    action.sa_handler = handler;
    sigaction (signal, &action, nullptr);
}

void handleUnlessIgnored (int signal, void (*handler) (int))
{
    struct sigaction before = {};
    sigaction (signal, nullptr, &before);

    if (before.sa_handler != SIG_IGN)
        handle (signal, handler);
}

/** The folder of a variable, else one at home; a path that is not absolute counts as not set. */
std::optional<std::filesystem::path> userHome (const char* variable, const char* usual)
{
    if (const auto* const folder = std::getenv (variable); folder != nullptr && *folder == '/')
        return folder;

    if (const auto* const home = std::getenv ("HOME"); home != nullptr && *home == '/')
        return std::filesystem::path (home) / usual;

    return std::nullopt;
}
} // namespace

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

void keepFreedMemory()
{
#ifdef __GLIBC__
    constexpr int largestFromHeap = 1 << 30; // bytes
    mallopt (M_MMAP_THRESHOLD, largestFromHeap);
    mallopt (M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

int ownUser()
{
    return static_cast<int> (getuid());
}

std::vector<std::string> programArguments (int count, char** arguments)
{
    return { arguments, arguments + count };
}

void guardStandardStreams()
{
    // Not ignored, which the commands that we run would inherit.
    std::signal (SIGPIPE, [] (int) {});

    for (const auto stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
        if (fcntl (stream, F_GETFD) < 0)
            open ("/dev/null", O_RDONLY); // The lowest number that is free is this one's.
}

bool errorsGoToTerminal()
{
    return isatty (STDERR_FILENO) != 0;
}

void handleEndingSignals (void (*handler) (int))
{
    for (const auto signal : { SIGINT, SIGTERM, SIGQUIT })
        handle (signal, handler);

    for (const auto signal : { SIGHUP, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU })
        handleUnlessIgnored (signal, handler);
}

void handleBrokenPipes (void (*handler) (int))
{
    handleUnlessIgnored (SIGPIPE, handler);
}

void endBySignal (int signal)
{
    std::signal (signal, SIG_DFL);
    raise (signal);
}

std::optional<CommandOutcome> runShellCommand (const std::string& command)
{
    auto* const pipe = popen (command.c_str(), "re");

    if (pipe == nullptr)
        return std::nullopt;

    CommandOutcome outcome;
    std::array<char, 256> some {};

    while (std::fgets (some.data(), some.size(), pipe) != nullptr)
        outcome.printed += some.data();

    const auto status = pclose (pipe);
    outcome.exitCode = WIFEXITED (status) ? WEXITSTATUS (status) : 1;
    return outcome;
}

std::optional<std::filesystem::path> userDataHome()
{
    return userHome ("XDG_DATA_HOME", ".local/share");
}

std::optional<std::filesystem::path> userConfigHome()
{
    return userHome ("XDG_CONFIG_HOME", ".config");
}

std::optional<std::filesystem::path> userCacheHome()
{
    return userHome ("XDG_CACHE_HOME", ".cache");
}

bool isIpv4Address (const std::string& text)
{
    in_addr ignored {};
    return inet_pton (AF_INET, text.c_str(), &ignored) == 1;
}

std::vector<std::size_t> waitForSockets (std::span<const int> sockets, int milliseconds)
{
    std::vector<pollfd> waited;
    std::vector<std::size_t> ready;
    waited.reserve (sockets.size());

    for (const auto socket : sockets)
        waited.push_back ({ socket, POLLIN, 0 });

    if (poll (waited.data(), waited.size(), milliseconds) > 0)
        for (std::size_t i = 0; i < waited.size(); ++i)
            if (waited[i].revents != 0)
                ready.push_back (i);

    return ready;
}
} // namespace antinode

#endif
