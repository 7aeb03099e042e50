#pragma once

#include "RunProgram.h"

#include <cstdint>
#include <cstdio>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>

namespace antinode::test
{
/** The variables that say where the user's devices and the cache are. */
inline constexpr auto userDataVariable = "APPDATA", userCacheVariable = "LOCALAPPDATA";

/** UTF-8 in the encoding of Windows. */
inline std::wstring wideText (const std::string& text)
{
    return std::filesystem::path (std::u8string (text.begin(), text.end())).wstring();
}

/** A word as the started program's main() takes it apart again: in quotes, with backslashes doubled before a quote. */
inline std::wstring quotedWord (const std::wstring& word)
{
    std::wstring quoted = L"\"";
    std::size_t backslashes = 0;

    for (const auto character : word)
    {
        if (character == L'"')
            quoted.append (backslashes + 1, L'\\');

        backslashes = character == L'\\' ? backslashes + 1 : 0;
        quoted += character;
    }

    return quoted.append (backslashes, L'\\') + L'"';
}

/** Sets variables of this process, which programs that it starts inherit, for a scope. */
class OwnEnvironment
{
public:
    explicit OwnEnvironment (const ProgramEnvironment& variables)
    {
        for (const auto& [name, value] : variables)
        {
            const auto* const before = _wgetenv (wideText (name).c_str());
            kept[wideText (name)] = before == nullptr ? L"" : before;
            _wputenv_s (wideText (name).c_str(), value.c_str());
        }
    }

    ~OwnEnvironment()
    {
        for (const auto& [name, value] : kept)
            _wputenv_s (name.c_str(), value.c_str());
    }

    OwnEnvironment (const OwnEnvironment&) = delete;
    OwnEnvironment& operator= (const OwnEnvironment&) = delete;

private:
    std::map<std::wstring, std::wstring> kept;
};

/** Sends what is written to a stream of this process, and of programs that it starts, to a file for a scope. */
class Redirection
{
public:
    Redirection (int redirected, const std::filesystem::path& path) : stream (redirected), kept (_dup (redirected))
    {
        std::fflush (nullptr);
        const auto file = _wopen (path.c_str(), _O_CREAT | _O_TRUNC | _O_WRONLY | _O_BINARY, _S_IREAD | _S_IWRITE);
        _dup2 (file, stream);
        _close (file);
    }

    ~Redirection()
    {
        _dup2 (kept, stream);
        _close (kept);
    }

    Redirection (const Redirection&) = delete;
    Redirection& operator= (const Redirection&) = delete;

private:
    int stream, kept;
};

/** Starts the built program; its output goes to files in the folder. */
inline std::intptr_t startProgram (const ProgramArguments& arguments, const std::filesystem::path& folder,
                                   const ProgramEnvironment& environment = {})
{
    const OwnEnvironment variables (environment);
    const Redirection output (1, folder / "stdout"), errors (2, folder / "stderr");
    const std::filesystem::path program (ANTINODE_PROGRAM);
    std::vector<std::wstring> words { quotedWord (program.wstring()) };
    std::vector<const wchar_t*> pointers;

    for (const auto& argument : arguments)
        words.push_back (quotedWord (wideText (argument.text)));

    for (const auto& word : words)
        pointers.push_back (word.c_str());

    pointers.push_back (nullptr);
    return _wspawnv (_P_NOWAIT, program.c_str(), pointers.data());
}

/** Waits for a started program: its exit code. */
inline int waitForProgram (std::intptr_t program)
{
    int status = 127;
    _cwait (&status, program, 0);
    return status;
}
} // namespace antinode::test
