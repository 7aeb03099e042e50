#include "LatencyVolts.h"

#include <Eigen/Core>

#include <cmath>

namespace antinode
{
std::optional<double> noiseVolts (const TouchSnapshot& snapshot, const PlayControls& controls, std::size_t latency)
{
    const auto& design = snapshot.designs[latency];

    if (design == nullptr)
        return {};

    // Noises of different inputs add by their powers; three times their RMS cancels against the inputs'.
    const Eigen::Map<const Eigen::ArrayXd> levels (controls.levels.data(), mostFingers);
    const Eigen::VectorXd powers = design->noiseGains.array().square().matrix() * levels.square().matrix();
    return std::sqrt (powers.maxCoeff());
}

juce::String latencyVoltsText (const TouchSnapshot& snapshot, const PlayControls& controls)
{
    juce::StringArray parts;

    for (std::size_t i = 0; i < touchLatencies.size(); ++i)
        if (const auto volts = noiseVolts (snapshot, controls, i))
            parts.add (juce::String (juce::roundToInt (1000 * touchLatencies[i])) + " ms: "
                       + (*volts < 10 ? juce::String (*volts, 1) : juce::String (juce::roundToInt (*volts))) + " V");

    return parts.joinIntoString (",  ");
}
} // namespace antinode
