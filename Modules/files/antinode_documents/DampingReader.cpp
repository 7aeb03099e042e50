#include "DampingReader.h"

#include <antinode_text/PhysicalRanges.h>

namespace antinode
{
namespace
{
constexpr std::string_view ratioKey = "damping_ratio";
constexpr std::string_view qualityKey = "quality_factor";

double ratioOfQuality (double qualityFactor)
{
    return 1 / (2 * qualityFactor);
}
} // namespace

std::vector<double> readDampingRatios (const JsonObject& object)
{
    const auto [key, value] = object.oneOf (ratioKey, qualityKey);

    if (key == ratioKey)
        return value.numberOrNumbers (ranges::maximumModes, ranges::dampingRatio);

    auto ratios = value.numberOrNumbers (ranges::maximumModes, ranges::qualityFactor);

    for (auto& ratio : ratios)
        ratio = ratioOfQuality (ratio);

    return ratios;
}

double readDampingRatio (const JsonObject& mode)
{
    const auto [key, value] = mode.oneOf (ratioKey, qualityKey);
    return key == ratioKey ? value.number (ranges::dampingRatio)
                           : ratioOfQuality (value.number (ranges::qualityFactor));
}
} // namespace antinode
