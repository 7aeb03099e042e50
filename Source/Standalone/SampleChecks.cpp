#include "SampleChecks.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
int firstBadSample (std::span<const float* const> channels, int offset, int count)
{
    for (const auto* const channel : channels)
        for (int n = 0; n < count; ++n)
            if (! std::isfinite (channel[offset + n]))
                count = n;

    return count;
}

void copyWithin (const float* from, float* to, int count, double factor, std::int64_t& clamped)
{
    for (int n = 0; n < count; ++n)
    {
        // In single precision the product of a limit could come out beyond full scale.
        const auto value = static_cast<float> (static_cast<double> (from[n]) * factor);
        const auto allowed = std::isfinite (value) ? std::clamp (value, -1.0F, 1.0F) : 0.0F;
        clamped += static_cast<int> (std::abs (value) > 1.0F);
        to[n] = allowed;
    }
}

float absolutePeak (const float* samples, int count)
{
    float peak = 0;

    for (int n = 0; n < count; ++n)
        peak = std::max (peak, std::abs (samples[n]));

    return peak;
}
} // namespace antinode
