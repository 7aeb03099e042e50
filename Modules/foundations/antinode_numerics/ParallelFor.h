#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace antinode
{
/** How many threads the processor runs at once, at least 1. [any] */
std::size_t processorThreads();

/** Calls work (0) to work (count - 1), each once, begun in ascending order, on several threads, the calling one among
    them; returns when all have ended. All look at the watches of the calling one. An exception ends the work: no
    further index is begun, and the exception of the lowest index reaches the caller.
    @param threads  how many at most, at least 1; where work calls this again, all of it together has no more
    [worker] */
void parallelFor (std::size_t count, const std::function<void (std::size_t)>& work,
                  std::size_t threads = processorThreads());

/** Hears how many cases are done, from any thread, one at a time. */
using ShowCases = std::function<void (std::uint64_t done)>;

/** Counts the cases that several threads finish. */
class CaseCounter
{
public:
    /** @param show  may be empty */
    explicit CaseCounter (ShowCases showToUse) : show (std::move (showToUse)) {}

    /** So many more are done. [worker, several at once] */
    void add (std::uint64_t cases = 1);

private:
    std::mutex mutex;
    std::uint64_t done = 0;
    const ShowCases show;
};

/** The results of cases 0 to count - 1, each of which depends on its number alone: the same for any number of threads.
    @param evaluate  gives the result of a case, on any thread
    @param show      may be empty
    @throws  what evaluate throws of the lowest case that threw; Cancelled, when a watch of this thread says no
    [worker], on all cores. Docs/Design/sweeps.md. */
template <typename Result>
std::vector<Result> evaluateCases (std::size_t count, const std::function<Result (std::size_t)>& evaluate,
                                   ShowCases show = {}, std::size_t threads = processorThreads())
{
    std::vector<Result> results (count);
    CaseCounter counter (std::move (show));
    parallelFor (
        count,
        [&] (std::size_t number)
        {
            results[number] = evaluate (number);
            counter.add();
        },
        threads);
    return results;
}
} // namespace antinode
