#ifdef _WIN32

#include "System.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <utility>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <winsock2.h> // before windows.h, which includes another version of it

#include <windows.h>

#include <shellapi.h>
#include <ws2tcpip.h>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

namespace antinode
{
namespace
{
std::optional<std::filesystem::path> userHome (const wchar_t* variable)
{
    const auto* const folder = _wgetenv (variable);
    const std::filesystem::path path (folder == nullptr ? L"" : folder);
    return path.is_absolute() ? std::optional (path) : std::nullopt;
}

/** Bytes of the UTF-8 character that begins with this one; 0 where none does. */
std::size_t utf8Length (unsigned char first)
{
    if (first < 0x80)
        return 1;

    if (first < 0xC2 || first > 0xF4)
        return 0;

    return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}
} // namespace

/** What the linker takes for mbrtowc(): by it, g++'s library makes paths of text, and Microsoft's older C library knows
    no UTF-8. A character beyond 16 bits comes in two calls: the state keeps its second half. [any] */
extern "C" std::size_t __wrap_mbrtowc (wchar_t* to, const char* from, std::size_t count, std::mbstate_t* state)
{
    constexpr auto wrong = static_cast<std::size_t> (-1), unfinished = static_cast<std::size_t> (-2);
    thread_local std::mbstate_t ownState {};
    auto& secondHalf = state == nullptr ? ownState : *state;
    wchar_t ignored = 0;
    auto& unit = to == nullptr ? ignored : *to;

    if (from == nullptr)
        return 0;

    if (count == 0)
        return unfinished;

    if (secondHalf != 0)
    {
        unit = static_cast<wchar_t> (std::exchange (secondHalf, 0));
        return 1;
    }

    const auto first = static_cast<unsigned char> (*from);
    const auto length = utf8Length (first);
    auto character = length == 1 ? first : first & (0x7Fu >> length);
    auto isValid = length > 0;

    for (std::size_t i = 1; i < length && isValid; ++i)
    {
        if (i == count)
            return unfinished;

        isValid = (static_cast<unsigned> (from[i]) & 0xC0u) == 0x80;
        character = (character << 6) | (static_cast<unsigned> (from[i]) & 0x3Fu);
    }

    if (! isValid)
    {
        errno = EILSEQ;
        return wrong;
    }

    if (length < 4)
    {
        unit = static_cast<wchar_t> (character);
        return character == 0 ? 0 : length;
    }

    unit = static_cast<wchar_t> (0xD7C0 + (character >> 10));
    secondHalf = static_cast<std::mbstate_t> (0xDC00 | (character & 0x3FF));
    return length - 1;
}

/** A folder cannot be opened: that is found here, for statusOf(). */
int openForReading (const std::filesystem::path& path)
{
    std::error_code error;

    if (std::filesystem::is_directory (path, error))
    {
        // A handle with backup semantics is the one way to a folder's descriptor.
        auto* const handle = CreateFileW (path.c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                                          OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
        return handle == INVALID_HANDLE_VALUE
                   ? -1
                   : _open_osfhandle (reinterpret_cast<std::intptr_t> (handle), _O_RDONLY | _O_BINARY);
    }

    return _wopen (path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

std::optional<FileStatus> statusOf (int descriptor)
{
    auto* const handle = reinterpret_cast<HANDLE> (_get_osfhandle (descriptor));
    BY_HANDLE_FILE_INFORMATION information {};

    if (GetFileType (handle) == FILE_TYPE_PIPE)
        return FileStatus { false, false, true, 0 };

    if (GetFileType (handle) != FILE_TYPE_DISK)
        return FileStatus {};

    if (! GetFileInformationByHandle (handle, &information))
        return std::nullopt;

    const auto isFolder = (information.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
    const auto bytes = (std::uintmax_t { information.nFileSizeHigh } << 32) | information.nFileSizeLow;
    return FileStatus { ! isFolder, isFolder, false, isFolder ? 0 : bytes };
}

std::ptrdiff_t readBytes (int descriptor, char* to, std::size_t count)
{
    return _read (descriptor, to, static_cast<unsigned> (std::min<std::size_t> (count, INT_MAX)));
}

void closeFile (int descriptor)
{
    _close (descriptor);
}

int ownProcess()
{
    return static_cast<int> (GetCurrentProcessId());
}

bool isProcessRunning (int process)
{
    auto* const handle = OpenProcess (SYNCHRONIZE, FALSE, static_cast<DWORD> (process));

    if (handle == nullptr)
        return GetLastError() == ERROR_ACCESS_DENIED;

    const auto isRunning = WaitForSingleObject (handle, 0) == WAIT_TIMEOUT;
    CloseHandle (handle);
    return isRunning;
}

std::string computerName()
{
    std::array<char, 256> name {};
    auto length = static_cast<DWORD> (name.size());
    return GetComputerNameExA (ComputerNameDnsHostname, name.data(), &length) != 0 ? name.data() : "";
}

void keepFreedMemory() {}

int ownUser()
{
    return 0;
}

std::vector<std::string> programArguments (int count, char** arguments)
{
    SetConsoleOutputCP (CP_UTF8);
    int wideCount = 0;
    auto** const wide = CommandLineToArgvW (GetCommandLineW(), &wideCount);

    if (wide == nullptr)
        return { arguments, arguments + count };

    std::vector<std::string> texts;

    for (int i = 0; i < wideCount; ++i)
    {
        std::string text (
            static_cast<std::size_t> (WideCharToMultiByte (CP_UTF8, 0, wide[i], -1, nullptr, 0, nullptr, nullptr)),
            ' ');
        WideCharToMultiByte (CP_UTF8, 0, wide[i], -1, text.data(), static_cast<int> (text.size()), nullptr, nullptr);
        text.pop_back(); // its 0
        texts.push_back (text);
    }

    LocalFree (static_cast<void*> (wide));
    return texts;
}

void guardStandardStreams() {}

bool errorsGoToTerminal()
{
    return _isatty (_fileno (stderr)) != 0;
}

void handleEndingSignals (void (*handler) (int))
{
    for (const auto signal : { SIGINT, SIGTERM, SIGBREAK })
        std::signal (signal, handler);
}

void handleBrokenPipes (void (*) (int)) {}

void endBySignal (int signal)
{
    std::signal (signal, SIG_DFL);
    std::raise (signal);
}

std::optional<CommandOutcome> runShellCommand (const std::string& command)
{
    auto* const pipe = _popen (command.c_str(), "r");

    if (pipe == nullptr)
        return std::nullopt;

    CommandOutcome outcome;
    std::array<char, 256> some {};

    while (std::fgets (some.data(), some.size(), pipe) != nullptr)
        outcome.printed += some.data();

    outcome.exitCode = _pclose (pipe);
    return outcome;
}

std::optional<std::filesystem::path> userDataHome()
{
    return userHome (L"APPDATA");
}

std::optional<std::filesystem::path> userConfigHome()
{
    return userHome (L"APPDATA");
}

std::optional<std::filesystem::path> userCacheHome()
{
    return userHome (L"LOCALAPPDATA");
}

bool isIpv4Address (const std::string& text)
{
    in_addr ignored {};
    return inet_pton (AF_INET, text.c_str(), &ignored) == 1;
}

std::vector<std::size_t> waitForSockets (std::span<const int> sockets, int milliseconds)
{
    std::vector<WSAPOLLFD> waited;
    std::vector<std::size_t> ready;

    for (const auto socket : sockets)
        waited.push_back ({ static_cast<SOCKET> (socket), POLLIN, 0 });

    if (WSAPoll (waited.data(), static_cast<ULONG> (waited.size()), milliseconds) > 0)
        for (std::size_t i = 0; i < waited.size(); ++i)
            if (waited[i].revents != 0)
                ready.push_back (i);

    return ready;
}
} // namespace antinode

#endif
