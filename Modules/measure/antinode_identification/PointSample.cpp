#include "PointSample.h"

#include <algorithm>

namespace antinode
{
std::vector<Eigen::Index> samplePoints (const FrequencyResponses& responses)
{
    constexpr Eigen::Index enough = 24; // as many directions as the search for poles keeps
    const auto all = responses.points.rows(), count = std::min (all, enough);
    std::vector<Eigen::Index> points;

    for (Eigen::Index n = 0; n < count; ++n)
        points.push_back ((2 * n + 1) * all / (2 * count));

    return points;
}

FrequencyResponses atPoints (const FrequencyResponses& responses, const std::vector<Eigen::Index>& points)
{
    auto result = FrequencyResponses { responses.frequencies,
                                       responses.drive,
                                       responses.references,
                                       responses.points (points, Eigen::all),
                                       {},
                                       {},
                                       responses.integrations,
                                       responses.isQuantityStated };

    for (const auto& values : responses.values)
        result.values.emplace_back (values (Eigen::all, points));

    for (const auto& variances : responses.variances)
        result.variances.emplace_back (variances (Eigen::all, points));

    return result;
}

IdentificationOptions atPoints (IdentificationOptions options, const std::vector<Eigen::Index>& points)
{
    if (options.pointWeights.size() > 0)
        options.pointWeights = options.pointWeights (points).eval();

    if (options.pointMasses.size() > 0)
        options.pointMasses = options.pointMasses (points).eval();

    return options;
}
} // namespace antinode
