#include "MidiTriggers.h"

#include <algorithm>
#include <optional>

namespace antinode
{
namespace
{
std::optional<FocusEvent> eventFrom (const juce::MidiMessage& message, int offset)
{
    if (message.isNoteOn())
        return FocusEvent { offset, FocusEventKind::trigger, message.getNoteNumber(), message.getVelocity() / 127.0 };

    if (message.isNoteOff())
        return FocusEvent { offset, FocusEventKind::release, message.getNoteNumber(), 0 };

    if (stopsAll (message))
        return FocusEvent { offset, FocusEventKind::stopAll, 0, 0 };

    return std::nullopt;
}
} // namespace

bool stopsAll (const juce::MidiMessage& message)
{
    constexpr int allSoundOff = 120, allNotesOff = 123, systemReset = 0xff;
    const auto isReset = message.getRawDataSize() == 1 && message.getRawData()[0] == systemReset;
    const auto controller = message.isController() ? message.getControllerNumber() : 0;
    return isReset || controller == allSoundOff || controller >= allNotesOff;
}

std::span<const FocusEvent> MidiTriggers::read (const juce::MidiBuffer& midi, int blockLength)
{
    std::size_t count = 0;

    for (const auto metadata : midi)
    {
        // Longer messages are never notes; getMessage() would allocate for them.
        if (metadata.numBytes > 3)
            continue;

        const auto offset = std::clamp (metadata.samplePosition, 0, std::max (0, blockLength - 1));

        if (const auto event = eventFrom (metadata.getMessage(), offset))
        {
            // What comes before a stop ends with it.
            count = isStop (*event) ? std::min (count, events.size() - 1) : count;

            if (count < events.size())
                events[count++] = *event;
        }
    }

    return { events.data(), count };
}
} // namespace antinode
