#include "LoadedLibrary.h"

#include <stdexcept>
#include <string>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace antinode::test
{
void* loadLibrary (const char* path)
{
#ifdef _WIN32
    void* const library = LoadLibraryA (path);
    const auto why = "error " + std::to_string (GetLastError()) + " of Windows";
#else
    void* const library = dlopen (path, RTLD_NOW | RTLD_LOCAL);
    const std::string why = library == nullptr ? dlerror() : "";
#endif

    if (library == nullptr)
        throw std::runtime_error (std::string ("the library ") + path + " is not loaded: " + why);

    return library;
}

void* symbolOf (void* library, const char* name)
{
#ifdef _WIN32
    auto* const symbol = reinterpret_cast<void*> (GetProcAddress (static_cast<HMODULE> (library), name));
#else
    auto* const symbol = dlsym (library, name);
#endif

    if (symbol == nullptr)
        throw std::runtime_error (std::string ("the library has no ") + name);

    return symbol;
}
} // namespace antinode::test
