#include "AudioChoice.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
std::string joined (const std::vector<std::string>& words)
{
    std::string text;

    for (const auto& word : words)
        text += (text.empty() ? "" : ", ") + word;

    return text;
}

juce::AudioIODeviceType& deviceType (juce::AudioDeviceManager& manager, const std::string& name)
{
    for (auto* const type : manager.getAvailableDeviceTypes())
        if (type->getTypeName().equalsIgnoreCase (juce::String (name)))
            return *type;

    throw InputError ("audio device type '" + name + "'",
                      "does not exist; available: " + joined (deviceTypes (manager)));
}

/** The first type that has an output device, where the user has chosen none. */
std::string firstType (juce::AudioDeviceManager& manager)
{
    const auto types = deviceTypes (manager);

    if (types.empty())
        throw InputError ("audio", "is not available: this program was built without types of audio devices");

    const auto found = std::find_if (types.begin(), types.end(),
                                     [&manager] (const auto& type) { return ! outputDevices (manager, type).empty(); });

    if (found == types.end())
    {
        const auto hasJack = std::find (types.begin(), types.end(), "JACK") != types.end();
        throw InputError ("audio", "has no outputs on this computer with " + joined (types)
                                       + (hasJack ? "; JACK needs a running server" : ""));
    }

    return *found;
}

std::string chosenDevice (juce::AudioDeviceManager& manager, const AudioChoice& choice, const std::string& type)
{
    const auto names = outputDevices (manager, type);

    if (names.empty())
        throw InputError (type, type == "JACK" ? "has no outputs: is a JACK server running?"
                                               : "has no outputs on this computer; try another type");

    if (choice.device.empty())
        return names.front();

    if (std::find (names.begin(), names.end(), choice.device) == names.end())
        throw InputError (type + " device '" + choice.device + "'", "does not exist; available: " + joined (names));

    return choice.device;
}

/** The input device of the same name, else the first one. */
juce::String inputDevice (juce::AudioIODeviceType& type, const juce::String& device)
{
    const auto names = type.getDeviceNames (true);

    if (names.isEmpty())
        throw InputError (type.getTypeName().toStdString(), "has no inputs on this computer");

    return names.contains (device) ? device : names[0];
}

juce::AudioDeviceManager::AudioDeviceSetup makeSetup (const AudioChoice& choice, const std::string& device)
{
    juce::AudioDeviceManager::AudioDeviceSetup setup;
    setup.outputDeviceName = juce::String::fromUTF8 (device.c_str());
    setup.sampleRate = choice.sampleRate;
    setup.bufferSize = choice.blockSize;
    setup.useDefaultInputChannels = false;
    setup.useDefaultOutputChannels = false;

    for (const auto output : choice.outputs)
        setup.outputChannels.setBit (output);

    for (const auto input : choice.inputs)
        setup.inputChannels.setBit (input);

    if (choice.opensAllInputs)
        setup.inputChannels.setRange (0, maximumDeviceOutputs, true);

    if (choice.outputs.empty())
        setup.outputChannels.setRange (0, maximumDeviceOutputs, true);

    return setup;
}

std::vector<int> openChannels (const juce::BigInteger& open)
{
    std::vector<int> channels;

    for (auto i = open.findNextSetBit (0); i >= 0; i = open.findNextSetBit (i + 1))
        channels.push_back (i);

    return channels;
}

/** Devices fall back silently to what they support, so compare with the request. */
void checkOpened (const juce::AudioIODevice& device, const AudioChoice& choice)
{
    auto& opened = const_cast<juce::AudioIODevice&> (device);
    const auto name = opened.getTypeName().toStdString() + " device '" + opened.getName().toStdString() + "'";
    const auto rate = opened.getCurrentSampleRate();
    const auto block = opened.getCurrentBufferSizeSamples();
    const auto channels = opened.getOutputChannelNames().size(), inputs = opened.getInputChannelNames().size();

    if (choice.sampleRate > 0 && std::abs (rate - choice.sampleRate) > 0.5)
        throw InputError (name, "plays at " + std::to_string (std::lround (rate)) + " Hz, not at "
                                    + std::to_string (std::lround (choice.sampleRate)) + " Hz");

    if (choice.blockSize > 0 && block != choice.blockSize)
        throw InputError (name, "uses blocks of " + std::to_string (block) + " samples, not "
                                    + std::to_string (choice.blockSize));

    for (const auto output : choice.outputs)
        if (output >= channels)
            throw InputError (name, "has " + std::to_string (channels) + " output channels; there is no output "
                                        + std::to_string (output + 1));

    for (const auto input : choice.inputs)
        if (input >= inputs)
            throw InputError (name, "has " + std::to_string (inputs) + " input channels; there is no input "
                                        + std::to_string (input + 1));
}
} // namespace

std::vector<std::string> deviceTypes (juce::AudioDeviceManager& manager)
{
    std::vector<std::string> names;

    for (auto* const type : manager.getAvailableDeviceTypes())
        names.push_back (type->getTypeName().toStdString());

    return names;
}

std::vector<std::string> outputDevices (juce::AudioDeviceManager& manager, const std::string& typeName)
{
    auto& type = deviceType (manager, typeName);
    type.scanForDevices();
    std::vector<std::string> names;

    for (const auto& name : type.getDeviceNames (false))
        names.push_back (name.toStdString());

    return names;
}

void openAudio (juce::AudioDeviceManager& manager, const AudioChoice& choice)
{
    auto& found = deviceType (manager, choice.type.empty() ? firstType (manager) : choice.type);
    const auto type = found.getTypeName();
    const auto device = chosenDevice (manager, choice, type.toStdString());
    manager.setCurrentAudioDeviceType (type, true);
    auto setup = makeSetup (choice, device);

    if (! choice.inputs.empty() || choice.opensAllInputs)
        setup.inputDeviceName = inputDevice (found, setup.outputDeviceName);

    if (const auto failure = manager.setAudioDeviceSetup (setup, true); failure.isNotEmpty())
        throw InputError (type.toStdString() + " device '" + device + "'",
                          "cannot be opened: " + failure.toLowerCase().toStdString());

    try
    {
        checkOpened (*manager.getCurrentAudioDevice(), choice);
    }
    catch (const InputError&)
    {
        manager.closeAudioDevice();
        throw;
    }
}

AudioChoice openedAudio (juce::AudioDeviceManager& manager)
{
    AudioChoice choice;

    if (auto* const device = manager.getCurrentAudioDevice())
    {
        choice.type = device->getTypeName().toStdString();
        choice.device = manager.getAudioDeviceSetup().outputDeviceName.toStdString();
        choice.sampleRate = device->getCurrentSampleRate();
        choice.blockSize = device->getCurrentBufferSizeSamples();
        choice.outputs = openChannels (device->getActiveOutputChannels());
        choice.inputs = openChannels (device->getActiveInputChannels());
    }

    return choice;
}
} // namespace antinode
