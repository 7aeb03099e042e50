#include "RateChange.h"

#include <antinode_numerics/KaiserSinc.h>

namespace antinode
{
Eigen::VectorXf rateChangeTaps (Eigen::Index factor)
{
    constexpr double shape = 7; // Kaiser's beta: -70 dB
    const auto reach = rateChangeReach * factor;
    Eigen::VectorXf taps (2 * reach + 1);

    for (Eigen::Index n = 0; n < taps.size(); ++n)
        taps[n] = static_cast<float> (
            kaiserSinc (static_cast<double> (n - reach) / static_cast<double> (factor), rateChangeReach, shape));

    return taps;
}
} // namespace antinode
