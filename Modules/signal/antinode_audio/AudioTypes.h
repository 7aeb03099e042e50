#pragma once

#include <string>
#include <vector>

namespace antinode
{
/** Names of the types of audio devices that programs for this system have, in JUCE's order. JUCE is not asked: on
    Windows it would make windows for it. [any] */
std::vector<std::string> systemDeviceTypes();

/** "Type of the audio device: ALSA or JACK", with the types of this system: for `--help`. [any] */
std::string deviceTypeHelp();

/** What distinguishes the types of this system, in a sentence. [any] */
std::string deviceTypeDifference();
} // namespace antinode
