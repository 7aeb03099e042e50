#include "ResponseLines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** How fast the responses may change at a frequency, 1/Hz: the slopes of the resonances' phases, none of which ever
   vanishes. */
double density (const IdentifiedModes& modes, double frequency)
{
    auto largest = 0.0;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto resonance = modes.angularFrequencies[k] / (2 * std::numbers::pi);
        const auto halfWidth = std::max (modes.dampingRatios[k] * resonance, 1e-9 * resonance);
        largest = std::max (largest, halfWidth / (halfWidth * halfWidth + std::pow (frequency - resonance, 2)));
    }

    return largest;
}
} // namespace

std::vector<Eigen::Index> usedLines (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    constexpr double rounding = 1e-9; // The limits are lines, through rad/s and back.
    std::vector<Eigen::Index> lines;

    for (Eigen::Index f = 0; f < responses.frequencies.size(); ++f)
        if (responses.frequencies[f] >= modes.minimumFrequency * (1 - rounding)
            && responses.frequencies[f] <= modes.maximumFrequency * (1 + rounding))
            lines.push_back (f);

    return lines;
}

std::vector<Eigen::Index> thinnedLines (const std::vector<Eigen::Index>& lines, const FrequencyResponses& responses,
                                        const IdentifiedModes& modes, Eigen::Index count)
{
    const auto size = static_cast<Eigen::Index> (lines.size());

    if (size <= count)
        return lines;

    // What has passed since the first line: half by changes of phase, half evenly.
    Eigen::VectorXd passed (size);
    passed[0] = 0;

    for (Eigen::Index n = 1; n < size; ++n)
    {
        const auto from = responses.frequencies[lines[static_cast<std::size_t> (n - 1)]];
        const auto to = responses.frequencies[lines[static_cast<std::size_t> (n)]];
        passed[n] = passed[n - 1] + density (modes, (from + to) / 2) * (to - from);
    }

    passed += Eigen::VectorXd::LinSpaced (size, 0, std::max (passed[size - 1], 1.0));
    std::vector<Eigen::Index> result { lines.front() };
    const auto step = passed[size - 1] / static_cast<double> (count - 1);

    for (Eigen::Index n = 1; n + 1 < size; ++n)
        if (std::floor (passed[n] / step) > std::floor (passed[n - 1] / step))
            result.push_back (lines[static_cast<std::size_t> (n)]);

    result.push_back (lines.back());
    return result;
}

FrequencyResponses atLines (const FrequencyResponses& responses, const std::vector<Eigen::Index>& lines)
{
    auto result = FrequencyResponses {
        responses.frequencies (lines), responses.drive,           responses.references, responses.points, {}, {},
        responses.integrations,        responses.isQuantityStated
    };

    for (const auto& values : responses.values)
        result.values.emplace_back (values (lines, Eigen::all));

    for (const auto& variances : responses.variances)
        result.variances.emplace_back (variances (lines, Eigen::all));

    return result;
}
} // namespace antinode
