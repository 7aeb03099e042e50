#pragma once

#include "PeakMeters.h"
#include "TouchSettings.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace antinode
{
/** The newest of some numbers that one thread writes, for others to draw: while it writes, the oldest of what is read
   may be newer than it seems. */
class FingerTrace
{
public:
    static constexpr std::size_t length = 1024;

    /** [audio thread] one writer */
    void push (float value)
    {
        const auto count = written.load (std::memory_order_relaxed);
        values[count % length].store (value, std::memory_order_relaxed);
        written.store (count + 1, std::memory_order_release);
    }

    /** The newest ones, the oldest of them first; 0 in place of those that were never written. @param count  at most
        `length` [any but the audio thread] */
    std::vector<float> newest (std::size_t count) const
    {
        std::vector<float> read;
        const auto end = written.load (std::memory_order_acquire) + length;

        for (auto i = end - count; i < end; ++i)
            read.push_back (values[i % length].load (std::memory_order_relaxed));

        return read;
    }

    /** How many were written so far. [any] */
    std::uint64_t count() const { return written; }

private:
    std::array<std::atomic<float>, length> values {};
    std::atomic<std::uint64_t> written { 0 };
};

/** Levels of the audio thread for other threads. */
struct FingerMeters
{
    PeakMeters<mostFingers> inputs;              ///< Of full scale.
    PeakMeters<mostFingers> displacements;       ///< m within the band: what is asked for.
    PeakMeters<mostFingers> felt;                ///< Times the threshold of skin.
    std::array<FingerTrace, mostFingers> traces; ///< m within the band, sample by sample of the filters.
    std::atomic<double> traceRate { 0 };         ///< Hz, of the traces; 0 before anything plays.
};
} // namespace antinode
