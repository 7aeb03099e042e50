#pragma once

#include <cstdlib>
#include <string>

namespace antinode::test
{
/** Sets a variable of the environment of this process, also for plug-ins in it. */
inline void setVariable (const char* name, const std::string& value)
{
#ifdef _WIN32
    _putenv_s (name, value.c_str());
#else
    setenv (name, value.c_str(), 1);
#endif
}

inline void removeVariable (const char* name)
{
#ifdef _WIN32
    _putenv_s (name, "");
#else
    unsetenv (name);
#endif
}
} // namespace antinode::test
