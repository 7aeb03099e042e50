#include "MidiQueue.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
bool MidiQueue::push (const juce::MidiMessage& message, double milliseconds)
{
    const auto size = message.getRawDataSize();
    const std::lock_guard lock (pushing);
    const auto position = written.load (std::memory_order_relaxed);

    if (size < 1 || size > 3 || position - read.load (std::memory_order_acquire) == capacity)
        return false;

    auto& entry = ring[position % capacity];
    std::copy_n (message.getRawData(), size, entry.bytes.begin());
    entry.size = size;
    entry.milliseconds = milliseconds;
    written.store (position + 1, std::memory_order_release);
    return true;
}

void MidiQueue::pop (juce::MidiBuffer& buffer, double milliseconds, double sampleRate, int count)
{
    const auto end = written.load (std::memory_order_acquire);

    for (auto position = read.load (std::memory_order_relaxed); position != end; ++position)
    {
        const auto& entry = ring[position % capacity];
        const auto age = (milliseconds - entry.milliseconds) * sampleRate / 1000;
        const auto offset = std::clamp (count - age, 0.0, std::max (0, count - 1) * 1.0);
        buffer.addEvent (entry.bytes.data(), entry.size, static_cast<int> (offset));
    }

    read.store (end, std::memory_order_release);
}
} // namespace antinode
