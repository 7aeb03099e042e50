#include "Ticks.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
// Beyond this, differences and products of two values would overflow.
constexpr double largest = 1e150;

// Below this fraction of its values a span has too few digits left to tell ticks apart.
constexpr double minimumRelativeSpan = 1e-9;
} // namespace

AxisRange usableRange (AxisRange range)
{
    if (! std::isfinite (range.minimum) || ! std::isfinite (range.maximum))
        return {};

    const auto low = std::clamp (std::min (range.minimum, range.maximum), -largest, largest);
    const auto high = std::clamp (std::max (range.minimum, range.maximum), -largest, largest);
    const auto magnitude = std::max (std::abs (low), std::abs (high));
    if (magnitude < 1 / largest)
        return { -1, 1 };
    if (high - low >= minimumRelativeSpan * magnitude)
        return { low, high };
    return { low - 0.1 * magnitude, high + 0.1 * magnitude };
}

double niceStep (double span, int maximumParts)
{
    const auto raw = span / std::max (1, maximumParts);
    const auto decade = std::pow (10.0, std::floor (std::log10 (raw)));
    for (const auto factor : { 1.0, 2.0, 5.0 })
        if (factor * decade >= raw * (1 - 1e-9))
            return factor * decade;
    return 10 * decade;
}

std::vector<double> linearTicks (AxisRange range, int maximumTicks)
{
    const auto [low, high] = usableRange (range);
    std::vector<double> ticks;
    for (auto parts = std::max (1, maximumTicks); ticks.size() < 2 && parts <= 4 * std::max (1, maximumTicks); ++parts)
    {
        const auto step = niceStep (high - low, parts);
        const auto first = std::ceil (low / step - 1e-6);
        const auto count = static_cast<std::size_t> (std::max (0.0, std::floor (high / step + 1e-6) - first + 1));
        ticks.resize (count);
        for (std::size_t k = 0; k < count; ++k)
            ticks[k] = (first + static_cast<double> (k)) * step;
    }
    return ticks;
}

std::vector<double> decadeTicks (AxisRange range, int maximumTicks)
{
    const auto first = static_cast<int> (std::ceil (std::log10 (range.minimum) - 1e-9));
    const auto last = static_cast<int> (std::floor (std::log10 (range.maximum) + 1e-9));
    const auto parts = std::max (1, maximumTicks);
    const auto stride = std::max (1, (last - first + parts) / parts);
    std::vector<double> ticks;
    for (auto exponent = first; exponent <= last; exponent += stride)
        ticks.push_back (std::pow (10.0, exponent));
    return ticks;
}

AxisRange niceRange (AxisRange range, int maximumParts)
{
    const auto [low, high] = usableRange (range);
    const auto step = niceStep (high - low, maximumParts);
    return { std::floor (low / step + 1e-6) * step, std::ceil (high / step - 1e-6) * step };
}
} // namespace antinode
