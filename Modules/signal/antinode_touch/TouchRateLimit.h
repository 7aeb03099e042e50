#pragma once

#include <chrono>
#include <deque>

namespace antinode
{
/** Limits the number in any second. */
class TouchRateLimit
{
public:
    using Time = std::chrono::steady_clock::time_point;

    explicit TouchRateLimit (int perSecondToAllow) : perSecond (perSecondToAllow) {}

    /** Whether one more may pass; if so, it has. Times do not go back. [any] */
    bool allows (Time now);

private:
    int perSecond;
    std::deque<Time> passed; ///< In the last second.
};
} // namespace antinode
