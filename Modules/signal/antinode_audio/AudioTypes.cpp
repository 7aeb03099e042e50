#include "AudioTypes.h"

#include <juce_core/juce_core.h>

#include <array>

namespace antinode
{
namespace
{
#if JUCE_WINDOWS
constexpr std::array types { "Windows Audio", "Windows Audio (Exclusive Mode)", "Windows Audio (Low Latency Mode)",
                             "DirectSound" };
constexpr auto difference =
    "Exclusive Mode opens the interface for this program alone; the others share it with the sounds of all programs.";
#elif JUCE_MAC
constexpr std::array types { "CoreAudio" };
constexpr auto difference = "CoreAudio is the audio system of macOS.";
#else
constexpr std::array types { "ALSA", "JACK" };
constexpr auto difference = "ALSA opens the interface itself; JACK uses a running server, including that of PipeWire.";
#endif
} // namespace

std::vector<std::string> systemDeviceTypes()
{
    return { types.begin(), types.end() };
}

std::string deviceTypeHelp()
{
    std::string text = "Type of the audio device: ";

    for (std::size_t i = 0; i < types.size(); ++i)
    {
        if (i > 0)
            text += i + 1 < types.size() ? ", " : " or ";

        text += types[i];
    }

    return text;
}

std::string deviceTypeDifference()
{
    return difference;
}
} // namespace antinode
