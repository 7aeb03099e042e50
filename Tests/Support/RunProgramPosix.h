#pragma once

#include "RunProgram.h"

#include <cstdlib>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace antinode::test
{
/** The variables that say where the user's devices and the cache are. */
inline constexpr auto userDataVariable = "XDG_DATA_HOME", userCacheVariable = "XDG_CACHE_HOME";

/** Starts the built program; its output goes to files in the folder. */
inline pid_t startProgram (const ProgramArguments& arguments, const std::filesystem::path& folder,
                           const ProgramEnvironment& environment = {})
{
    const auto program = fork();

    if (program != 0)
        return program;

    const auto redirect = [&] (const char* name, int stream)
    { dup2 (open ((folder / name).c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), stream); };
    redirect ("stdout", STDOUT_FILENO);
    redirect ("stderr", STDERR_FILENO);

    for (const auto& [name, value] : environment)
        setenv (name.c_str(), value.c_str(), 1);

    std::vector<char*> words { const_cast<char*> (ANTINODE_PROGRAM) };

    for (const auto& argument : arguments)
        words.push_back (const_cast<char*> (argument.text.c_str()));

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
} // namespace antinode::test
