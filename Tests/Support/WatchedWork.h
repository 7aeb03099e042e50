#pragma once

#include <antinode_base/Watch.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace antinode::test
{
/** How long each thread of some work computes between two looks at its watch, in time of the processor, which no load
    of the machine changes. */
class WatchedWork
{
public:
    /** Runs the work on this thread. @param maximum  ms of all threads, after which it is cancelled */
    template <typename Work>
    explicit WatchedWork (const Work& work, double maximumTime = std::numeric_limits<double>::infinity())
        : maximum (maximumTime)
    {
        last[std::this_thread::get_id()] = processorTime();

        try
        {
            const WatchScope scope ([this] { return look(); });
            work();
        }
        catch (const Cancelled&)
        {
            wasCancelled = true;
        }

        look();
    }

    /** ms from any instant of the work until the next look, half of all instants wait less. A cancelled work returns
        that much later. */
    double medianWait() const
    {
        // Within an interval the wait falls evenly from its length to 0.
        double low = 0, high = worstWait();

        for (int i = 0; i < 50; ++i)
            (timeWaiting (0.5 * (low + high)) > 0.5 * total ? low : high) = 0.5 * (low + high);

        return low;
    }

    double worstWait() const { return intervals.empty() ? 0 : *std::max_element (intervals.begin(), intervals.end()); }
    std::size_t looks() const { return intervals.size(); }

    /** ms of all threads together. */
    double duration() const { return total; }
    bool isCancelled() const { return wasCancelled; }

private:
    /** ms of this thread. */
    static double processorTime()
    {
        timespec time {};
        clock_gettime (CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e3 * static_cast<double> (time.tv_sec) + 1e-6 * static_cast<double> (time.tv_nsec);
    }

    bool look()
    {
        const auto now = processorTime();
        const std::lock_guard lock (mutex);

        auto& before = last[std::this_thread::get_id()]; // 0: the thread has just begun

        // The name of a thread that has ended may be given to another.
        intervals.push_back (now < before ? now : now - before);
        before = now;
        total += intervals.back();
        return total <= maximum;
    }

    /** ms of the work from which the next look is more than `wait` away. */
    double timeWaiting (double wait) const
    {
        double time = 0;

        for (const auto interval : intervals)
            time += std::max (0.0, interval - wait);

        return time;
    }

    std::mutex mutex;
    std::map<std::thread::id, double> last; ///< ms
    std::vector<double> intervals;          ///< ms
    double maximum, total = 0;              ///< ms
    bool wasCancelled = false;
};
} // namespace antinode::test
