#pragma once

#include "TemporaryFolder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace antinode::test
{
/** What a run of the program left. */
struct ProgramRun
{
    int exitCode = 0; ///< Or 128 + signal.
    std::string output, errors;
};

inline std::string readContent (const std::filesystem::path& path)
{
    std::ifstream stream (path, std::ios::binary);
    return { std::istreambuf_iterator<char> (stream), {} };
}

/** Starts the built program; its output goes to files in the folder, and its modes are cached in there too. */
inline pid_t startProgram (const std::vector<std::string>& arguments, const std::filesystem::path& folder)
{
    const auto program = fork();

    if (program != 0)
        return program;

    const auto redirect = [&] (const char* name, int stream)
    { dup2 (open ((folder / name).c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), stream); };
    redirect ("stdout", STDOUT_FILENO);
    redirect ("stderr", STDERR_FILENO);
    setenv ("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    std::vector<char*> words { const_cast<char*> (ANTINODE_PROGRAM) };

    for (const auto& argument : arguments)
        words.push_back (const_cast<char*> (argument.c_str()));

    words.push_back (nullptr);
    execv (ANTINODE_PROGRAM, words.data());
    _exit (127);
}

/** Waits for a started program: its exit code, or 128 + the signal that ended it. */
inline int waitForProgram (pid_t program)
{
    int status = 0;
    waitpid (program, &status, 0);
    return WIFEXITED (status) ? WEXITSTATUS (status) : 128 + WTERMSIG (status);
}

inline ProgramRun runProgram (const std::vector<std::string>& arguments)
{
    const TemporaryFolder folder;
    const auto exitCode = waitForProgram (startProgram (arguments, folder.path()));
    return { exitCode, readContent (folder.path() / "stdout"), readContent (folder.path() / "stderr") };
}
} // namespace antinode::test
