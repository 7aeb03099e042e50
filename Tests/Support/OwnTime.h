#pragma once

#include <chrono>
#include <cstdint>
#include <fstream>

namespace antinode::test
{
/** Milliseconds of the present thread without those in which it could have run and others were running: what a wait
   lasts, also on a machine that is busy. */
class OwnTime
{
public:
    OwnTime() : start (Clock::now()), delayed (delay()) {}

    double milliseconds() const
    {
        const std::chrono::duration<double, std::milli> passed = Clock::now() - start;
        return passed.count() - 1e-6 * static_cast<double> (delay() - delayed);
    }

private:
    using Clock = std::chrono::steady_clock;

    /** ns on the run queue so far; 0 where the kernel does not say. */
    static std::int64_t delay()
    {
        std::ifstream file ("/proc/thread-self/schedstat");
        std::int64_t ran = 0, waited = 0;
        return file >> ran >> waited ? waited : 0;
    }

    Clock::time_point start;
    std::int64_t delayed;
};
} // namespace antinode::test
