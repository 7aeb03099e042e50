#include "Progress.h"

#include "MessageText.h"

#include <cmath>

namespace antinode
{
std::string durationInWords (double seconds)
{
    const auto rounded = std::lround (seconds);

    if (rounded < 60)
        return formatted ("%ld s", rounded);

    const auto minutes = std::lround (seconds / 60);
    return minutes < 60 ? formatted ("%ld min", minutes) : formatted ("%ld h %ld min", minutes / 60, minutes % 60);
}

std::string timeLeftInWords (double elapsed, double share)
{
    constexpr double minimumTime = 2, minimumShare = 0.02;

    if (elapsed < minimumTime || share < minimumShare || share >= 1)
        return {};

    return "about " + durationInWords (std::ceil (elapsed * (1 - share) / share)) + " left";
}

std::string TimeLeft::at (double share) const
{
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begun;
    return before < 1 ? timeLeftInWords (elapsed.count(), (share - before) / (1 - before)) : std::string();
}
} // namespace antinode
