#include "IdentifyTone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
double IdentifyTone::amplitude (double voltageLimit)
{
    return voltageLimit > 0 ? std::min (maximumVolts, shareOfLimit * voltageLimit) : 0;
}

double IdentifyTone::at (std::int64_t sample, double sampleRate)
{
    const auto time = std::fmod (static_cast<double> (sample) / sampleRate, period);

    if (time >= burst)
        return 0;

    const auto toEdge = std::clamp (std::min (time, burst - time) / edge, 0.0, 1.0);
    const auto window = 0.5 - 0.5 * std::cos (std::numbers::pi * toEdge);
    return window * std::sin (2 * std::numbers::pi * frequency * time);
}
} // namespace antinode
