#include "SafetyRamp.h"

#include <algorithm>
#include <array>
#include <functional>

namespace antinode
{
namespace
{
constexpr int piece = 64; // samples

double safeGain (double gain)
{
    return gain > 0 && gain <= 1 ? gain : 0.0;
}
} // namespace

SafetyRamp::SafetyRamp (double gain) : start (safeGain (gain)), end (start) {}

void SafetyRamp::setTarget (double target, std::int64_t samples)
{
    start = gain();
    end = safeGain (target);
    length = left = std::max<std::int64_t> (0, samples);
}

double SafetyRamp::gain() const
{
    return left > 0 ? end + (start - end) * (static_cast<double> (left) / static_cast<double> (length)) : end;
}

template <typename Sample>
void SafetyRamp::process (Sample* const* channels, int channelCount, int count)
{
    if (left == 0 && end == 1) // As nearly always: armed, and no sample changes.
        return;

    std::array<Sample, piece> gains;

    for (int done = 0; done < count;)
    {
        const auto samples = std::min (piece, count - done);

        for (int n = 0; n < samples; ++n)
        {
            left -= left > 0;
            gains[static_cast<std::size_t> (n)] = static_cast<Sample> (gain());
        }

        for (int i = 0; i < channelCount; ++i)
            std::transform (gains.data(), gains.data() + samples, channels[i] + done, channels[i] + done,
                            std::multiplies<>());

        done += samples;
    }
}

template void SafetyRamp::process (double* const*, int, int);
template void SafetyRamp::process (float* const*, int, int);
} // namespace antinode
