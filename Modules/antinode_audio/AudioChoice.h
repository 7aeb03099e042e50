#pragma once

#include <juce_audio_devices/juce_audio_devices.h>

#include <string>
#include <vector>

namespace antinode
{
/** Which audio device, and how. What is empty or 0 is left to the device. */
struct AudioChoice
{
    std::string type;           ///< "ALSA" or "JACK"
    std::string device;         ///< Of the type, as it is listed.
    double sampleRate = 0;      ///< Hz
    int blockSize = 0;          ///< Samples.
    std::vector<int> outputs;   ///< Channels that are opened, counted from 0; empty: all.
    std::vector<int> inputs {}; ///< Channels that are opened, counted from 0; empty: none.

    bool operator== (const AudioChoice&) const = default;
};

/** The names of a type's devices that have outputs. @throws InputError  when there is no such type [message thread] */
std::vector<std::string> outputDevices (juce::AudioDeviceManager&, const std::string& type);

/** The names of all types. [message thread] */
std::vector<std::string> deviceTypes (juce::AudioDeviceManager&);

/** How many outputs of a device are opened at most. */
constexpr int mostDeviceOutputs = 128;

/** Opens what was chosen.
    @throws InputError  where there is none, or it does not open, or not with that rate, block or so many channels; then it is closed
    [message thread] */
void openAudio (juce::AudioDeviceManager&, const AudioChoice&);

/** What is open now; `type` is empty where nothing is. [message thread] */
AudioChoice openedAudio (juce::AudioDeviceManager&);
} // namespace antinode
