#include "QuietLibraries.h"

#ifdef __linux__

#include <alsa/asoundlib.h>
#include <dlfcn.h>

#include <initializer_list>

namespace antinode
{
namespace
{
void ignoreJack (const char*) {}

void ignoreAlsa (const char*, int, const char*, int, const char*, ...) {}
} // namespace

void silenceAudioLibraries()
{
    snd_lib_error_set_handler (ignoreAlsa);

    // JUCE loads the same library later; it is never unloaded.
    auto* const jack = dlopen ("libjack.so.0", RTLD_LAZY);

    if (jack == nullptr)
        return;

    using SetFunction = void (*) (void (*) (const char*));

    for (const auto* const name : { "jack_set_error_function", "jack_set_info_function" })
        if (auto* const symbol = dlsym (jack, name))
            reinterpret_cast<SetFunction> (symbol) (ignoreJack);
}
} // namespace antinode

#else

void antinode::silenceAudioLibraries() {}

#endif
