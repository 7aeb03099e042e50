#include "MidiQueue.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
bool MidiQueue::push (const juce::MidiMessage& message, double milliseconds)
{
    const auto size = message.getRawDataSize();

    if (size < 1 || size > 3)
        return false;

    Entry entry { {}, size, milliseconds };
    std::copy_n (message.getRawData(), size, entry.bytes.begin());
    const std::lock_guard lock (pushing);
    return waiting.push (entry);
}

void MidiQueue::pop (juce::MidiBuffer& buffer, double milliseconds, double sampleRate, int count)
{
    // No more than wait now: the buffer has no room for what comes meanwhile.
    for (auto left = waiting.size(); left > 0; --left)
    {
        const auto entry = waiting.pop().value();
        const auto age = (milliseconds - entry.milliseconds) * sampleRate / 1000;
        const auto offset = std::clamp (count - age, 0.0, std::max (0, count - 1) * 1.0);
        buffer.addEvent (entry.bytes.data(), entry.size, static_cast<int> (offset));
    }
}
} // namespace antinode
