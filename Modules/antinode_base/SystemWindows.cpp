#ifdef _WIN32

#include "Processes.h"
#include "SystemFiles.h"

#include <algorithm>
#include <array>
#include <climits>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

namespace antinode
{
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
} // namespace antinode

#endif
