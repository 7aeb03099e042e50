#include "TouchRateLimit.h"

#include <cstdint>

namespace antinode
{
bool TouchRateLimit::allows (Time now)
{
    while (! passed.empty() && now - passed.front() >= std::chrono::seconds (1))
        passed.pop_front();

    if (static_cast<std::int64_t> (passed.size()) >= perSecond)
        return false;

    passed.push_back (now);
    return true;
}
} // namespace antinode
