#pragma once

#include <antinode_base/Watch.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace antinode::test
{
/** How long each thread of some work computes between two looks at its watch, in time of the processor, which no load of the machine changes. */
class WatchedWork
{
public:
    /** Runs the work on this thread. */
    template <typename Work>
    explicit WatchedWork (const Work& work)
    {
        const WatchScope scope ([this] { return look(); });
        look();
        work();
        look();
    }

    /** ms from any instant of the work until the next look, half of all instants wait less. A cancelled work returns that much later. */
    double medianWait() const
    {
        // Within an interval the wait falls evenly from its length to 0.
        double low = 0, high = worstWait();

        for (int i = 0; i < 50; ++i)
            (timeWaiting (0.5 * (low + high)) > 0.5 * timeWaiting (0) ? low : high) = 0.5 * (low + high);

        return low;
    }

    double worstWait() const { return intervals.empty() ? 0 : *std::max_element (intervals.begin(), intervals.end()); }
    std::size_t looks() const { return intervals.size(); }

    /** ms of all threads together. */
    double duration() const { return timeWaiting (0); }

private:
    bool look()
    {
        timespec time {};
        clock_gettime (CLOCK_THREAD_CPUTIME_ID, &time);
        const auto now = 1e3 * static_cast<double> (time.tv_sec) + 1e-6 * static_cast<double> (time.tv_nsec);
        const std::lock_guard lock (mutex);

        if (const auto [place, isNew] = last.try_emplace (std::this_thread::get_id(), now); ! isNew)
            intervals.push_back (now - std::exchange (place->second, now));

        return true;
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
};
} // namespace antinode::test
