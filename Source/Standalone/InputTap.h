#pragma once

#include <antinode_base/RingQueue.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace antinode
{
/** The samples of an input on their way from the audio thread to the window, with peak and clipped samples. */
class InputTap
{
public:
    /** Samples from here on count as clipped, share of full scale. */
    static constexpr float clipping = 0.999F;

    /** Samples that the window does not take in time are left out; peak and clipped samples count all.
        @param samples  `count` of them; not a number counts as 0 [audio thread] */
    void write (const float* samples, int count);

    /** All samples since the last call, the oldest first, at most a third of a second at 192 kHz. One reader.
        [message thread] */
    std::vector<float> take();

    /** The largest magnitude since the last call, share of full scale. One reader. [any] */
    float takePeak() { return peak.exchange (0); }

    /** Samples at the end of the range so far. [any] */
    std::int64_t clippedSamples() const { return clipped; }

private:
    static constexpr std::size_t capacity = 1 << 16;

    RingQueue<float, capacity> waiting;
    std::atomic<float> peak { 0 };
    std::atomic<std::int64_t> clipped { 0 };
};
} // namespace antinode
