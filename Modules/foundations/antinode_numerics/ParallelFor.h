#pragma once

#include <cstddef>
#include <functional>

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
} // namespace antinode
