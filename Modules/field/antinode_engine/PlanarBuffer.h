#pragma once

#include "AlignedVector.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace antinode
{
/** Channels of samples, each of which starts on a cache line: kernels are some points quicker there. Channels are not a
   power of two apart, or they would drive each other out of the first cache. */
template <typename Sample>
class PlanarBuffer
{
public:
    PlanarBuffer() = default;

    /** All 0. [worker] allocates @param channels, length  at least 0 */
    PlanarBuffer (int channels, int length)
    {
        const auto lines = (static_cast<std::size_t> (length) + line - 1) / line;
        const auto stride = (lines | 1U) * line; // an odd number of lines
        samples.resize (stride * static_cast<std::size_t> (channels));

        for (std::size_t i = 0; i < static_cast<std::size_t> (channels); ++i)
            starts.push_back (samples.data() + i * stride);
    }

    PlanarBuffer (PlanarBuffer&&) noexcept = default;
    PlanarBuffer& operator= (PlanarBuffer&&) noexcept = default;
    PlanarBuffer (const PlanarBuffer&) = delete;
    PlanarBuffer& operator= (const PlanarBuffer&) = delete;
    ~PlanarBuffer() = default;

    /** A pointer to each channel. [any] */
    Sample* const* channels() const { return starts.data(); }
    Sample* channel (std::size_t index) const { return starts[index]; }
    std::size_t size() const { return starts.size(); }

    void fill (Sample value) { std::fill (samples.begin(), samples.end(), value); }

private:
    static constexpr std::size_t line = 64 / sizeof (Sample);

    AlignedVector<Sample> samples;
    std::vector<Sample*> starts;
};
} // namespace antinode
