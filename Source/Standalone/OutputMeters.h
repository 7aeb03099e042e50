#pragma once

#include "OutputRouting.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace antinode
{
/** Meters of each output for other threads: its peak since the last read, and the number of clamped samples. */
class OutputMeters
{
public:
    /** One writer. @param peak  share of full scale [audio thread] */
    void note (int output, float peak, std::int64_t clamped)
    {
        auto& present = peaks[static_cast<std::size_t> (output)];

        if (peak > present.load (std::memory_order_relaxed))
            present.store (peak, std::memory_order_relaxed);

        if (clamped > 0)
            clampedCounts[static_cast<std::size_t> (output)].fetch_add (clamped, std::memory_order_relaxed);
    }

    /** [audio thread] */
    void noteBadNumber() { badNumberCount.fetch_add (1, std::memory_order_relaxed); }

    /** The largest magnitude since the last call, share of full scale. One reader. [any] */
    float takePeak (int output) { return peaks[static_cast<std::size_t> (output)].exchange (0); }

    /** Samples that were beyond full scale and were held there. [any] */
    std::int64_t clampedSamples (int output) const { return clampedCounts[static_cast<std::size_t> (output)]; }

    /** Blocks in which something that is not finite came in: it went out as 0. [any] */
    std::int64_t badNumbers() const { return badNumberCount; }

private:
    std::array<std::atomic<float>, OutputRouting::maximumOutputs> peaks {};
    std::array<std::atomic<std::int64_t>, OutputRouting::maximumOutputs> clampedCounts {};
    std::atomic<std::int64_t> badNumberCount { 0 };
};
} // namespace antinode
