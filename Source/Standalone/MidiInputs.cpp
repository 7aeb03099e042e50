#include "MidiInputs.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int lookMilliseconds = 2000;
}

MidiInputs::MidiInputs (MidiQueue& queueToFill) : queue (queueToFill) {}

MidiInputs::~MidiInputs()
{
    stopTimer();
}

void MidiInputs::choose (const MidiChoice& wanted)
{
    chosen = wanted;
    update();
    startTimer (lookMilliseconds);
}

void MidiInputs::update()
{
    const auto devices = available();
    const auto isWanted = [&] (const juce::String& identifier)
    {
        const auto isThere = std::any_of (devices.begin(), devices.end(),
                                          [&] (const auto& device) { return device.identifier == identifier; });
        const auto& names = chosen.inputs;
        return isThere
               && (chosen.all || std::find (names.begin(), names.end(), identifier.toStdString()) != names.end());
    };
    refused.clear();
    missing = chosen.all
                  ? 0
                  : static_cast<int> (std::count_if (chosen.inputs.begin(), chosen.inputs.end(),
                                                     [&] (const auto& wanted)
                                                     { return ! isWanted (juce::String::fromUTF8 (wanted.c_str())); }));
    std::erase_if (inputs, [&] (const auto& input) { return ! isWanted (input->getIdentifier()); });

    for (const auto& device : devices)
    {
        const auto isOpen =
            std::any_of (inputs.begin(), inputs.end(),
                         [&] (const auto& input) { return input->getIdentifier() == device.identifier; });

        if (isOpen || ! isWanted (device.identifier))
            continue;

        if (auto input = juce::MidiInput::openDevice (device.identifier, this))
        {
            input->start();
            inputs.push_back (std::move (input));
        }
        else
            refused.push_back (device.name.toStdString());
    }
}

std::vector<UserMessage> MidiInputs::messages() const
{
    std::vector<UserMessage> messages;

    for (const auto& name : refused)
        addMessage (messages, Urgency::caution,
                    "MIDI input '" + name + "': cannot be opened; close the program that uses it");

    if (missing > 0)
        addMessage (messages, Urgency::caution,
                    std::to_string (missing) + (missing == 1 ? " chosen MIDI input is" : " chosen MIDI inputs are")
                        + " not plugged in. Plug it in, or choose others in Settings, MIDI.");

    return messages;
}

void MidiInputs::handleIncomingMidiMessage (juce::MidiInput*, const juce::MidiMessage& message)
{
    queue.push (message, message.getTimeStamp() * 1000);
}
} // namespace antinode
