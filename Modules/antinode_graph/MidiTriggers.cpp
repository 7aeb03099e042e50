#include "MidiTriggers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace antinode
{
namespace
{
std::optional<FocusEvent> eventFrom (const juce::MidiMessage& message, const VelocityCurve& curve, int offset)
{
    if (message.isNoteOn())
        return FocusEvent { offset, FocusEventKind::trigger, message.getNoteNumber(),
                            curve.amplitude (message.getVelocity()) };

    if (message.isNoteOff())
        return FocusEvent { offset, FocusEventKind::release, message.getNoteNumber(), 0 };

    if (message.isAllNotesOff() || message.isAllSoundOff())
        return FocusEvent { offset, FocusEventKind::stopAll, 0, 0 };

    return std::nullopt;
}
} // namespace

double VelocityCurve::amplitude (int velocity) const
{
    const auto share = std::pow (std::clamp (velocity, 1, 127) / 127.0, exponent);
    return std::clamp (minimum + (1 - minimum) * share, 0.0, 1.0);
}

std::span<const FocusEvent> MidiTriggers::read (const juce::MidiBuffer& midi, int blockLength)
{
    std::size_t count = 0;

    for (const auto metadata : midi)
    {
        if (count == events.size())
            break;

        // Longer messages are never notes; getMessage() would allocate for them.
        if (metadata.numBytes > 3)
            continue;

        const auto offset = std::clamp (metadata.samplePosition, 0, std::max (0, blockLength - 1));

        if (const auto event = eventFrom (metadata.getMessage(), curve, offset))
            events[count++] = *event;
    }

    return { events.data(), count };
}
} // namespace antinode
