#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

namespace antinode
{
/** Values on their way from one thread to another, in their order. One thread at a time pushes and one pops; neither
    allocates, locks nor waits. */
template <typename T, std::size_t capacityToUse>
class RingQueue
{
public:
    static constexpr std::size_t capacity = capacityToUse;
    static_assert (capacity > 0 && (capacity & (capacity - 1)) == 0, "The counters may wrap: allowed: a power of two");
    static_assert (std::atomic<std::size_t>::is_always_lock_free);

    /** @return  false where `capacity` values wait already: then this one is left out [audio thread] of the one that
        pushes */
    bool push (const T& value)
    {
        const auto position = written.load (std::memory_order_relaxed);

        if (position - read.load (std::memory_order_acquire) == capacity)
            return false;

        values[position % capacity] = value;
        written.store (position + 1, std::memory_order_release);
        return true;
    }

    /** Takes the oldest value, if there is one. [audio thread] of the one that pops */
    std::optional<T> pop()
    {
        const auto position = read.load (std::memory_order_relaxed);

        if (position == written.load (std::memory_order_acquire))
            return {};

        const std::optional<T> value (values[position % capacity]);
        read.store (position + 1, std::memory_order_release);
        return value;
    }

    /** How many values wait: for the thread that pops at least so many, for the one that pushes at most.
        [audio thread] */
    std::size_t size() const
    {
        const auto begin = read.load (std::memory_order_acquire); // First: it never passes what is written.
        return written.load (std::memory_order_acquire) - begin;
    }

private:
    std::array<T, capacity> values {};
    std::atomic<std::size_t> written { 0 }, read { 0 };
};
} // namespace antinode
