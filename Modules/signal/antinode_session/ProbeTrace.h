#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace antinode
{
/** The last second or so of the first probe's velocity, to be drawn: each entry is the largest and the least value of
    some samples. */
class ProbeTrace
{
public:
    static constexpr std::size_t capacity = 4096;

    struct Entry
    {
        float smallest = 0, largest = 0; ///< m/s
    };

    /** @param samples  how many make an entry, 1 or more; the one that is begun may be of either length [any] */
    void prepare (int samples) { samplesPerEntry.store (samples, std::memory_order_relaxed); }

    /** [audio thread] */
    void write (const double* velocities, int count);

    /** The newest entries, oldest first; torn ones are possible and last one frame. [any] */
    std::vector<Entry> newest (std::size_t count) const;

    /** The number of entries written so far. [any] */
    std::uint64_t written() const { return position.load (std::memory_order_acquire); }

private:
    std::atomic<int> samplesPerEntry { 48 };
    int inEntry = 0; ///< Of the audio thread, as the next line.
    Entry current;
    std::array<std::atomic<float>, capacity> smallest {}, largest {};
    std::atomic<std::uint64_t> position { 0 };
};
} // namespace antinode
