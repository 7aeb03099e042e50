#pragma once

#include <antinode_session/DesignWorker.h>

#include <numeric>
#include <vector>

namespace antinode::test
{
/** Waits until the newest request is designed and handed over at all of its places. */
inline void waitForBank (DesignWorker& worker, std::size_t places)
{
    std::vector<int> all (places);
    std::iota (all.begin(), all.end(), 0);
    worker.waitFor (all);
}
} // namespace antinode::test
