#pragma once

#include <cstddef>
#include <functional>

namespace antinode
{
/** Calls a function with each index from 0 to count - 1, on the calling thread and as many others as the processor runs. All look at the
    watches of the calling thread. After the first exception no further index is begun.
    @throws  that exception, once all threads are done
    [worker] */
void parallelFor (std::size_t count, const std::function<void (std::size_t)>&);
} // namespace antinode
