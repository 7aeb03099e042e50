#pragma once

#include <atomic>
#include <cstdint>

namespace antinode
{
/** The order between stops and all else that threads ask for: how often everything was stopped. What is asked for keeps
    the number of its time wherever it waits, and is void once there is a newer one. [any] */
class StopCount
{
public:
    std::uint64_t now() const { return stops; }

    /** Of those by stop(): what plays by itself, as the notes of a file do, ends with them, not with notes that stop.
     */
    std::uint64_t commands() const { return commanded; }

    /** A command of a person or a host. */
    void stop()
    {
        ++commanded;
        ++stops;
    }

    /** All notes off. @return  the number from now on */
    std::uint64_t stopByNote() { return ++stops; }

private:
    std::atomic<std::uint64_t> stops { 0 }, commanded { 0 };
    static_assert (std::atomic<std::uint64_t>::is_always_lock_free);
};
} // namespace antinode
