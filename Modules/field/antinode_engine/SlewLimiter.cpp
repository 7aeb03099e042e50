#include "SlewLimiter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr double aboveLimit = 1.001; // so that the limiter clamps, and counts, what is beyond
}

SlewLimiter::SlewLimiter (const Eigen::VectorXd& limitsToKeep, const Eigen::VectorXd& slews, double sampleRate)
    : limits (aboveLimit * limitsToKeep),
      steps ((slews.array() > 0).select (slews / sampleRate, std::numeric_limits<double>::infinity())),
      last (Eigen::VectorXd::Zero (limits.size()))
{
}

void SlewLimiter::process (const double* const* inputs, double* const* outputs, int count)
{
    for (Eigen::Index i = 0; i < limits.size(); ++i)
        for (int n = 0; n < count; ++n)
        {
            const auto wanted = inputs[i][n];

            if (std::isfinite (wanted))
                last[i] += std::clamp (std::clamp (wanted, -limits[i], limits[i]) - last[i], -steps[i], steps[i]);

            outputs[i][n] = std::isfinite (wanted) ? last[i] : wanted;
        }
}
} // namespace antinode
