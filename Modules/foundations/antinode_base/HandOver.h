#pragma once

#include "RingQueue.h"

#include <atomic>
#include <memory>

namespace antinode
{
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
