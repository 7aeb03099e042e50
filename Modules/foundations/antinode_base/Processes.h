#pragma once

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
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
} // namespace antinode
