#include "MidiQueue.h"

#include <antinode_graph/MidiTriggers.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
bool MidiQueue::push (const juce::MidiMessage& message, double milliseconds)
{
    const auto size = message.getRawDataSize();

    if (size < 1 || size > 3)
        return false;

    Entry entry { {}, size, milliseconds, stopCount.now() };
    std::copy_n (message.getRawData(), size, entry.bytes.begin());
    const std::lock_guard lock (pushing);
    const auto isTaken = waiting.push (entry);

    if (! isTaken && stopsAll (message))
        stopCount.stopByNote();

    return isTaken;
}

void MidiQueue::pop (juce::MidiBuffer& buffer, double milliseconds, double sampleRate, int count)
{
    // No more than wait now: the buffer has no room for what comes meanwhile, and stops that these wait behind are
    // seen.
    auto left = waiting.size();

    for (const auto stop = stopCount.now(); left > 0; --left)
    {
        const auto entry = waiting.pop().value();

        if (entry.askedAt != stop)
            continue;

        const auto age = (milliseconds - entry.milliseconds) * sampleRate / 1000;
        const auto offset = std::clamp (count - age, 0.0, std::max (0, count - 1) * 1.0);
        buffer.addEvent (entry.bytes.data(), entry.size, static_cast<int> (offset));
    }
}
} // namespace antinode
