#include "FeltDisplacement.h"

#include <antinode_numerics/Fourier.h>

namespace antinode
{
Eigen::RowVectorXd feltDisplacement (const Eigen::VectorXd& displacement, double sampleRate,
                                     const SkinThreshold& threshold)
{
    constexpr double dyingAway = 0.1; // s, of the weighting itself
    const auto length = quickLength (static_cast<double> (displacement.size()) + dyingAway * sampleRate);
    auto spectrum = forwardFourier (displacement, length);
    spectrum[0] = 0;

    for (Eigen::Index k = 1; k < spectrum.size(); ++k)
        spectrum[k] /= thresholdAt (threshold, static_cast<double> (k) * sampleRate / static_cast<double> (length));

    return inverseFourier (spectrum, length).head (displacement.size()).transpose();
}
} // namespace antinode
