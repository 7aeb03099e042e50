#pragma once

#include "OwnTime.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace antinode::test
{
/** How long a host's calls took. */
class BlockingTimes
{
public:
    /** ms. By hand, on a quiet machine, the 50 ms that are promised. In the suite, whose machine may be busy, what is
       far below the seconds that a host waits where it waits for work at all. */
    static double allowed() { return std::getenv ("ANTINODE_BLOCKING_ROUNDS") != nullptr ? 50 : 2000; }

    template <typename Action>
    void measure (const std::string& name, const Action& action)
    {
        const OwnTime time;
        action();
        all[name].push_back (time.milliseconds());
    }

    double longest() const
    {
        double maximum = 0;

        for (const auto& [name, times] : all)
            maximum = std::max (maximum, *std::max_element (times.begin(), times.end()));

        return maximum;
    }

    /** A line an action. */
    void print()
    {
        for (auto& [name, times] : all)
        {
            std::sort (times.begin(), times.end());
            std::printf ("%-24s %4zu times, median %6.2f ms, most %6.2f ms\n", name.c_str(), times.size(),
                         times[times.size() / 2], times.back());
        }
    }

private:
    std::map<std::string, std::vector<double>> all;
};

/** ANTINODE_BLOCKING_ROUNDS, or a few: how often it is tried. */
inline int blockingRounds (int few)
{
    const auto* const asked = std::getenv ("ANTINODE_BLOCKING_ROUNDS");
    return asked != nullptr ? std::max (1, std::atoi (asked)) : few;
}
} // namespace antinode::test
