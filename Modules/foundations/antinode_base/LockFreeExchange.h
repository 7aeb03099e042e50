#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
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

/** Values on their way from a worker to the audio thread and back: one atomic exchange each way, no lock, no wait. A
   value that was given and not yet taken is replaced by the next one. Values come back when nothing plays them any
   more, and are freed by the worker. One worker thread at a time, one audio thread at a time. */
template <typename Value>
class HandOver
{
public:
    HandOver() = default;

    /** Frees everything; nothing may be playing. [worker] */
    ~HandOver()
    {
        collect();
        delete next.load();
    }

    HandOver (const HandOver&) = delete;
    HandOver& operator= (const HandOver&) = delete;

    /** Hands a value over and frees what came back. [worker] */
    void give (std::unique_ptr<const Value> value)
    {
        collect();
        delete next.exchange (value.release(), std::memory_order_acq_rel);
    }

    /** Frees what came back. [worker] */
    void collect()
    {
        while (const auto value = returned.pop())
            delete *value;
    }

    /** The newest value, or none if there was none since the last call. [audio thread] */
    const Value* take() { return next.exchange (nullptr, std::memory_order_acq_rel); }

    /** Whether a value can be given back at the moment. [audio thread] */
    bool canGiveBack() const { return returned.size() < returned.capacity; }

    /** Gives a value back to be freed; only where that is possible. [audio thread] */
    void giveBack (const Value* value) { returned.push (value); }

private:
    std::atomic<const Value*> next { nullptr };
    RingQueue<const Value*, 64> returned;
};
} // namespace antinode
