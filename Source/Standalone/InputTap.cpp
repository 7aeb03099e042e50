#include "InputTap.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
void InputTap::write (const float* samples, int count)
{
    auto largest = 0.0F;
    std::int64_t beyond = 0;

    for (int n = 0; n < count; ++n)
    {
        const auto sample = std::isfinite (samples[n]) ? samples[n] : 0.0F;
        largest = std::max (largest, std::abs (sample));
        beyond += std::abs (sample) >= clipping ? 1 : 0;
        waiting.push (sample);
    }

    if (largest > peak.load (std::memory_order_relaxed))
        peak.store (largest, std::memory_order_relaxed);

    if (beyond > 0)
        clipped.fetch_add (beyond, std::memory_order_relaxed);
}

std::vector<float> InputTap::take()
{
    std::vector<float> samples (waiting.size());

    for (auto& sample : samples)
        sample = waiting.pop().value_or (0.0F);

    return samples;
}
} // namespace antinode
