#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace antinode
{
/** Data of kernels starts on a cache line: a vector of 512 bits across two lines costs two loads. */
inline constexpr std::size_t cacheLine = 64;

/** Allocates on cache lines. */
template <typename Value>
struct CacheLineAllocator
{
    using value_type = Value;

    CacheLineAllocator() = default;

    template <typename Other>
    CacheLineAllocator (const CacheLineAllocator<Other>&)
    {
    }

    Value* allocate (std::size_t count)
    {
        return static_cast<Value*> (::operator new (count * sizeof (Value), std::align_val_t (cacheLine)));
    }

    void deallocate (Value* values, std::size_t) { ::operator delete (values, std::align_val_t (cacheLine)); }

    friend bool operator== (const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

/** A std::vector whose first value lies on a cache line. */
template <typename Value>
using AlignedVector = std::vector<Value, CacheLineAllocator<Value>>;

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
