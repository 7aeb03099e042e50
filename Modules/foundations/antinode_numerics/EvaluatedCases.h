#pragma once

#include "ParallelFor.h"

#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace antinode
{
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
