#include "ParallelFor.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace antinode
{
namespace
{
/** How many threads work that this thread begins may have. */
thread_local std::size_t allowedThreads = std::numeric_limits<std::size_t>::max();

/** As long as it lives, this thread's work has its share of the threads. */
class ThreadShare
{
public:
    explicit ThreadShare (std::size_t share) : before (allowedThreads) { allowedThreads = share; }
    ~ThreadShare() { allowedThreads = before; }

    ThreadShare (const ThreadShare&) = delete;
    ThreadShare& operator= (const ThreadShare&) = delete;

private:
    const std::size_t before;
};

/** The indices that are left, and the exception of the lowest that threw. All below an index were begun before it, so
    which exception is kept does not depend on the threads. */
class SharedIndices
{
public:
    SharedIndices (std::size_t countToUse, const std::function<void (std::size_t)>& workToUse)
        : count (countToUse), work (workToUse)
    {
    }

    void run()
    {
        // An index that was taken is always run: which exception is kept must not depend on the threads.
        while (! hasFailed)
        {
            const auto index = next++;

            if (index >= count)
                return;

            try
            {
                checkWatch();
                work (index);
            }
            catch (...)
            {
                keep (index, std::current_exception());
            }
        }
    }

    void rethrow() const
    {
        if (failure)
            std::rethrow_exception (failure);
    }

private:
    void keep (std::size_t index, std::exception_ptr exception)
    {
        const std::lock_guard lock (mutex);

        if (! failure || index < failedIndex)
        {
            failure = std::move (exception);
            failedIndex = index;
        }

        hasFailed = true;
    }

    const std::size_t count;
    const std::function<void (std::size_t)>& work;
    std::atomic<std::size_t> next { 0 };
    std::atomic<bool> hasFailed { false };
    std::mutex mutex;
    std::exception_ptr failure;
    std::size_t failedIndex = 0;
};
} // namespace

std::size_t processorThreads()
{
    return std::max (1U, std::thread::hardware_concurrency());
}

void parallelFor (std::size_t count, const std::function<void (std::size_t)>& work, std::size_t threads)
{
    SharedIndices indices (count, work);
    const auto watch = threadWatch();
    const auto most = std::min (threads, allowedThreads);
    const auto workers = std::max<std::size_t> (1, std::min (count, most));
    const auto share = std::max<std::size_t> (1, most / workers);

    {
        std::vector<std::jthread> others;

        try
        {
            for (std::size_t n = 1; n < workers; ++n)
                others.emplace_back (
                    [&indices, &watch, share]
                    {
                        const WatchScope scope (watch);
                        const ThreadShare own (share);
                        indices.run();
                    });
        }
        catch (const std::system_error&)
        {
            // The system gives no more threads: those that there are do all of it.
        }

        const ThreadShare own (share);
        indices.run();
    }

    indices.rethrow();
}

void CaseCounter::add (std::uint64_t cases)
{
    const std::lock_guard lock (mutex);
    done += cases;

    if (show)
        show (done);
}
} // namespace antinode
