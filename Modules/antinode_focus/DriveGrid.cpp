#include "DriveGrid.h"

#include "Prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
double gridLimitMargin()
{
    return std::cos (std::numbers::pi / gridSamplesPerCycle);
}

Eigen::MatrixXd sampleDrives (const std::vector<std::vector<Oscillation>>& drives, double first, double last)
{
    double highest = 0;

    for (const auto& drive : drives)
        for (const auto& oscillation : drive)
            highest = std::max (highest, std::abs (oscillation.exponent()) / (2 * std::numbers::pi));

    const auto steps = std::max (2.0, std::ceil ((last - first) * highest * gridSamplesPerCycle));
    Eigen::MatrixXd samples = Eigen::MatrixXd::Zero (drives.size(), static_cast<Eigen::Index> (steps) + 1);

    for (Eigen::Index l = 0; l < samples.rows(); ++l)
        for (Eigen::Index n = 0; n < samples.cols(); ++n)
            for (const auto& oscillation : drives[static_cast<std::size_t> (l)])
                samples (l, n) +=
                    oscillationValue (oscillation, last - (last - first) * (1 - static_cast<double> (n) / steps));

    return samples;
}
} // namespace antinode
