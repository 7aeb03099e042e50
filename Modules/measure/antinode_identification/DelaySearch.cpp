#include "DelaySearch.h"

#include <cmath>

namespace antinode
{
double searchDelay (const std::function<double (double)>& score, double highest, double price)
{
    // No measurement is late by more than some milliseconds.
    constexpr double longest = 3e-3, longDelay = 2e-4;
    const auto step = 0.25 / highest;
    const auto priced = [&] (double delay)
    { return score (delay) - price * std::abs (delay) / (std::abs (delay) + longDelay); };
    double best = 0, bestScore = priced (0);

    for (auto n = static_cast<long> (-longest / step); n <= static_cast<long> (longest / step); ++n)
        if (const auto delay = static_cast<double> (n) * step; priced (delay) > bestScore)
            bestScore = priced (best = delay);

    auto width = step;

    for (int halving = 0; halving < 20; ++halving, width /= 2)
        for (const auto delay : { best - width, best + width })
            if (score (delay) > score (best))
                best = delay;

    return best;
}
} // namespace antinode
