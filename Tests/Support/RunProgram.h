#pragma once

#include "TemporaryFolder.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace antinode::test
{
/** What a run of the program left. */
struct ProgramRun
{
    int exitCode = 0; ///< Or 128 + signal.
    std::string output, errors;
};

/** A word of a command, or the path of a file. */
struct ProgramArgument
{
    ProgramArgument (const char* word) : text (word) {}
    ProgramArgument (std::string word) : text (std::move (word)) {}
    ProgramArgument (const std::filesystem::path& path) : text (reinterpret_cast<const char*> (path.u8string().c_str()))
    {
    }

    std::string text; ///< UTF-8.
};

using ProgramArguments = std::vector<ProgramArgument>;

/** Variables of the environment of a run, beside those of the tests. */
using ProgramEnvironment = std::map<std::string, std::filesystem::path>;

inline std::string readContent (const std::filesystem::path& path)
{
    std::ifstream stream (path, std::ios::binary);
    return { std::istreambuf_iterator<char> (stream), {} };
}

inline std::ptrdiff_t linesIn (const std::string& text)
{
    return std::count (text.begin(), text.end(), '\n');
}
} // namespace antinode::test

#ifdef _WIN32
#include "RunProgramWindows.h"
#else
#include "RunProgramPosix.h"
#endif

namespace antinode::test
{
/** Runs the built program and waits for its end. */
inline ProgramRun runProgram (const ProgramArguments& arguments, const ProgramEnvironment& environment = {})
{
    const TemporaryFolder folder;
    const auto exitCode = waitForProgram (startProgram (arguments, folder.path(), environment));
    return { exitCode, readContent (folder.path() / "stdout"), readContent (folder.path() / "stderr") };
}
} // namespace antinode::test
