#include "SearchBands.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double bandRatio = 1.6, guardShare = 0.25;
constexpr double widest = 2 * std::numbers::pi * 2500; // rad/s
constexpr Eigen::Index fewestLines = 96;               // of a chosen band, where there are as many

SearchBand bandAround (const PreparedResponses& data, double minimum, double maximum)
{
    const auto* const begin = data.omega.data();
    const auto* const end = begin + data.lines();
    const auto guard = guardShare * (maximum - minimum);
    const auto first = std::lower_bound (begin, end, minimum - guard) - begin;
    const auto last = std::upper_bound (begin, end, maximum + guard) - begin;
    return { first, last - first, minimum, maximum };
}

std::vector<SearchBand> chosenBands (const PreparedResponses& data)
{
    const auto highest = data.omega[data.lines() - 1];
    std::vector<SearchBand> bands;

    for (auto lower = data.omega[0]; lower < highest;)
    {
        const auto* const line = std::lower_bound (data.omega.data(), data.omega.data() + data.lines(), lower);
        const auto enough = std::min<Eigen::Index> (line - data.omega.data() + fewestLines, data.lines() - 1);
        auto upper = std::max (std::min (bandRatio * lower, lower + widest), data.omega[enough]);

        // A remainder narrower than a third of a band is no band of its own.
        if (highest - upper < (upper - lower) / 3)
            upper = highest;

        bands.push_back (bandAround (data, lower, upper));
        lower = upper;
    }

    return bands;
}
} // namespace

std::vector<SearchBand> searchBands (const PreparedResponses& data, const std::vector<FrequencyBand>& wanted)
{
    if (wanted.empty())
        return chosenBands (data);

    std::vector<SearchBand> bands;

    for (const auto& [minimum, maximum] : wanted)
    {
        bands.push_back (bandAround (data, 2 * std::numbers::pi * minimum, 2 * std::numbers::pi * maximum));

        if (! (minimum < maximum) || bands.back().lines < 8)
            throw InputError ("band " + std::to_string (minimum) + " to " + std::to_string (maximum) + " Hz",
                              "contains fewer than 8 lines of the frequency responses; allowed: 8 or more");
    }

    return bands;
}

std::vector<SearchBand> splitBand (const PreparedResponses& data, const SearchBand& band)
{
    if (band.lines < 2 * fewestLines)
        return {};

    const auto middle = (band.minimum + band.maximum) / 2;
    return { bandAround (data, band.minimum, middle), bandAround (data, middle, band.maximum) };
}
} // namespace antinode
