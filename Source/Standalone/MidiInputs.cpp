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
    }
}

void MidiInputs::handleIncomingMidiMessage (juce::MidiInput*, const juce::MidiMessage& message)
{
    queue.push (message, message.getTimeStamp() * 1000);
}
} // namespace antinode
