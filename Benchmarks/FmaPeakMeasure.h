#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace antinode::bench
{
/** Seconds that some runs take. */
template <typename Work>
double measureSeconds (const Work& work, int runs)
{
    const auto begin = std::chrono::steady_clock::now();

    for (int i = 0; i < runs; ++i)
        work();

    benchmark::ClobberMemory();
    return std::chrono::duration<double> (std::chrono::steady_clock::now() - begin).count();
}

inline double computeMedian (std::vector<double> values)
{
    if (values.empty())
        return std::nan ("");

    std::nth_element (values.begin(), values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2), values.end());
    return values[values.size() / 2];
}

template <typename Work>
void measure (benchmark::State& state, double fmas, double items, const Work& work)
{
    constexpr double slice = 1e-3; // s: short beside what disturbs, long beside the clock
    const auto runs = std::max (1, static_cast<int> (slice / std::max (1e-9, measureSeconds (work, 1))));
    std::vector<double> fractions, nanoseconds;
    auto before = fmaVectorsPerSecond();

    for (auto iteration : state)
    {
        const auto seconds = measureSeconds (work, runs);
        const auto after = fmaVectorsPerSecond();

        if (std::abs (after - before) < 0.02 * after)
        {
            const auto possible = 0.5 * (before + after) * seconds * fmaLanes();
            fractions.push_back (runs * fmas / possible);
            nanoseconds.push_back (1e9 * seconds / (runs * items));
        }

        before = after;
    }

    state.counters["fma_fraction"] = computeMedian (fractions);
    state.counters["ns"] = computeMedian (nanoseconds);
    state.counters["slices"] = static_cast<double> (fractions.size());
}
} // namespace antinode::bench
