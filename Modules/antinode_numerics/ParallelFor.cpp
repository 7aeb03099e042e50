#include "ParallelFor.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace antinode
{
void parallelFor (std::size_t count, const std::function<void (std::size_t)>& function)
{
    std::atomic<std::size_t> next { 0 };
    std::exception_ptr failure;
    std::mutex mutex;
    const auto work = [&]
    {
        try
        {
            for (auto index = next++; index < count; index = next++)
            {
                checkWatch();
                function (index);
            }
        }
        catch (...)
        {
            next = count;
            const std::lock_guard lock (mutex);
            failure = failure ? failure : std::current_exception();
        }
    };
    const auto watch = watchOfThread();
    std::vector<std::thread> others;

    for (std::size_t i = 1; i < std::min<std::size_t> (count, std::thread::hardware_concurrency()); ++i)
        others.emplace_back (
            [&]
            {
                const WatchScope scope (watch);
                work();
            });

    work();

    for (auto& other : others)
        other.join();

    if (failure)
        std::rethrow_exception (failure);
}
} // namespace antinode
