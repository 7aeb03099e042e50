#pragma once

#include <juce_audio_devices/juce_audio_devices.h>

#include <string>
#include <vector>

namespace antinode
{
/** The audio device and its settings. Empty or 0 leaves the choice to the device. */
struct AudioChoice
{
    std::string type;            ///< One of the types of the system, such as "ALSA".
    std::string device;          ///< Name within the type, as listed.
    double sampleRate = 0;       ///< Hz
    int blockSize = 0;           ///< Samples.
    std::vector<int> outputs;    ///< Output channels to open, counted from 0; empty: all.
    std::vector<int> inputs {};  ///< Input channels to open, counted from 0; empty: none.
    bool opensAllInputs = false; ///< Opens all inputs that there are, in place of those.

    bool operator== (const AudioChoice&) const = default;
};

/** The names of a type's devices that have outputs. @throws InputError  when there is no such type [message thread] */
std::vector<std::string> outputDevices (juce::AudioDeviceManager&, const std::string& type);

/** The names of all types. [message thread] */
std::vector<std::string> deviceTypes (juce::AudioDeviceManager&);

/** The largest number of outputs opened on a device. */
constexpr int maximumDeviceOutputs = 128;

/** Opens what was chosen.
    @throws InputError  if there is none, or it does not open, or not with that rate, block or so many channels; then it
   is closed [message thread] */
void openAudio (juce::AudioDeviceManager&, const AudioChoice&);

/** The open device and its settings; `type` is empty if no device is open. [message thread] */
AudioChoice openedAudio (juce::AudioDeviceManager&);
} // namespace antinode
