#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace antinode
{
/** Arguments as main() hands them on; they point into the texts. [any] */
inline std::vector<char*> argumentPointers (std::vector<std::string>& texts)
{
    std::vector<char*> pointers;
    pointers.reserve (texts.size());

    for (auto& text : texts)
        pointers.push_back (text.data());

    return pointers;
}

/** The number of this process; above 0. [any] */
int ownProcess();

/** Whether a process of this number runs, be it another user's. [any] */
bool isProcessRunning (int process);

/** The number of the user whose process this is; 0 on Windows, where users have none. [any] */
int ownUser();

/** The name of this computer in its network; empty where the system does not say it. [worker] */
std::string computerName();

/** The arguments of this program in UTF-8, its name first: on Windows main() gets them in another encoding. There the
    console is set to UTF-8, too. [message thread] */
std::vector<std::string> programArguments (int count, char** arguments);

/** Lets this process keep the memory that it frees, up to 2 GB, instead of giving it back at once: large matrices come
    and go, and the system hands out their pages one by one. For programs, not for what is loaded into a host; where
    the C library is not glibc it does nothing. [message thread] Docs/Design/engine.md */
void keepFreedMemory();

/** Whether standard error goes to a terminal, which shows a line that is written again and again. [any] */
bool errorsGoToTerminal();

/** Calls a function at each signal that would end this process: of the keyboard, a closed terminal, other programs and
    timers. Those that it was started to ignore, as nohup does, stay ignored, but for what the keyboard and `kill` send.
    On Windows the next one of a kind does what it does by default. [message thread] */
void handleEndingSignals (void (*handler) (int));

/** The same at the signal of a pipe whose reader has gone, where there is one. [message thread] */
void handleBrokenPipes (void (*handler) (int));

/** Ends this process by a signal as if nothing handled it. [any] from within its handler too */
void endBySignal (int signal);

/** What a command did. */
struct CommandOutcome
{
    int exitCode = 0;    ///< 1 of a command that a signal has ended.
    std::string printed; ///< On standard output.
};

/** Runs a command in the system's shell and waits for its end.
    @return  nothing where it cannot be started [worker] */
std::optional<CommandOutcome> runShellCommand (const std::string& command);

/** Whether a text is an IPv4 address, for example 127.0.0.1. [any] */
bool isIpv4Address (const std::string&);

/** Waits until sockets have something to read, or have failed.
    @return  their places in the list; none after the time, or after a signal [worker] */
std::vector<std::size_t> waitForSockets (std::span<const int> sockets, int milliseconds);

/** Makes errors of writing out of what would end a program or spoil a file: a pipe that nobody reads any more, and
    standard streams that are closed, whose numbers the next file would get. On Windows neither happens.
    [message thread] */
void guardStandardStreams();

/** Writes out what was printed on standard output.
    @throws InputError  where it cannot be written as a whole: a full disk, a pipe that nobody reads [any] */
void requireWholeOutput();

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

/** Where programs keep a user's data: $XDG_DATA_HOME, else $HOME/.local/share; on Windows %APPDATA%. None where neither
   is set to an absolute path. XDG base directory specification. [any] */
std::optional<std::filesystem::path> userDataHome();

/** Where programs keep a user's settings: $XDG_CONFIG_HOME, else $HOME/.config; on Windows %APPDATA%. [any] */
std::optional<std::filesystem::path> userConfigHome();

/** Where programs keep what they can compute again: $XDG_CACHE_HOME, else $HOME/.cache; on Windows %LOCALAPPDATA%.
 * [any] */
std::optional<std::filesystem::path> userCacheHome();
} // namespace antinode
