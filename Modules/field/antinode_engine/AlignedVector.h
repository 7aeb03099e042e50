#pragma once

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
} // namespace antinode
