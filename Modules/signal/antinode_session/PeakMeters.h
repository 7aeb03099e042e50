#pragma once

#include <array>
#include <atomic>
#include <cstddef>

namespace antinode
{
/** The largest of each of some numbers since the last read: one thread writes, another one reads. */
template <std::size_t count>
class PeakMeters
{
public:
    /** [audio thread] @param value  at least 0 */
    void note (int index, float value)
    {
        auto& present = values[static_cast<std::size_t> (index)];

        // One writer: what a reader resets in between only makes a peak last a block longer.
        if (value > present.load (std::memory_order_relaxed))
            present.store (value, std::memory_order_relaxed);
    }

    /** [any] One reader. */
    float take (int index) { return values[static_cast<std::size_t> (index)].exchange (0); }

private:
    std::array<std::atomic<float>, count> values {};
};
} // namespace antinode
