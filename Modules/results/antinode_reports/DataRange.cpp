#include "DataRange.h"

#include "PlotFrame.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
std::optional<AxisRange> includingLimits (std::optional<AxisRange> range, const std::vector<LimitLine>& limits,
                                          bool positiveOnly)
{
    for (const auto& limit : limits)
        range = including (range, Eigen::VectorXd::Constant (1, limit.value), positiveOnly);
    return range;
}

std::optional<AxisRange> includingZero (std::optional<AxisRange> range)
{
    return including (range, Eigen::VectorXd::Zero (1));
}

// At least 5 % of air, then out to the next of up to sixteen steps.
AxisRange withAir (AxisRange range)
{
    const auto [low, high] = usableRange (range);
    const auto air = 0.05 * (high - low);
    const auto nice = niceRange ({ low - air, high + air }, 16);
    // Data that does not cross zero gets no strip beyond it.
    return { low >= 0 ? std::max (0.0, nice.minimum) : nice.minimum,
             high <= 0 ? std::min (0.0, nice.maximum) : nice.maximum };
}

AxisRange wholeDecades (AxisRange range)
{
    const auto [low, high] = positiveRange (range);
    const auto first = std::floor (std::log10 (low) + 1e-9);
    return { std::pow (10.0, first), std::pow (10.0, std::max (first + 1, std::ceil (std::log10 (high) - 1e-9))) };
}
} // namespace

std::optional<AxisRange> including (std::optional<AxisRange> range, const Eigen::Ref<const Eigen::VectorXd>& values,
                                    bool positiveOnly)
{
    for (const auto value : values)
        if (std::isfinite (value) && (value > 0 || ! positiveOnly))
            range = range ? AxisRange { std::min (range->minimum, value), std::max (range->maximum, value) }
                          : AxisRange { value, value };
    return range;
}

std::optional<AxisRange> xDataRange (const LineChart& chart)
{
    std::optional<AxisRange> range;
    for (const auto& series : chart.series)
        range = including (range, series.x, chart.logarithmicX);
    return range;
}

std::optional<AxisRange> yDataRange (const LineChart& chart)
{
    std::optional<AxisRange> range;
    auto filled = false;
    for (const auto& series : chart.series)
    {
        range = including (range, series.y, chart.logarithmicY);
        filled = filled || series.filled;
    }
    if (filled && ! chart.logarithmicY)
        range = includingZero (range);
    return includingLimits (range, chart.limits, chart.logarithmicY);
}

std::optional<AxisRange> yDataRange (const BarChart& chart)
{
    std::optional<AxisRange> range;
    for (const auto& series : chart.series)
        range = including (range, series.values, chart.logarithmic);
    if (! chart.logarithmic && range)
        range = includingZero (range);
    return includingLimits (range, chart.limits, chart.logarithmic);
}

std::optional<AxisRange> united (std::optional<AxisRange> one, std::optional<AxisRange> other)
{
    if (! one || ! other)
        return one ? one : other;
    return AxisRange { std::min (one->minimum, other->minimum), std::max (one->maximum, other->maximum) };
}

AxisRange niceDataRange (std::optional<AxisRange> range, bool logarithmic)
{
    const auto known = range.value_or (logarithmic ? AxisRange { 0.1, 1 } : AxisRange { 0, 1 });
    return logarithmic ? wholeDecades (known) : withAir (known);
}

void requireMatchingSizes (const LineChart& chart)
{
    for (const auto& series : chart.series)
        if (series.x.size() != series.y.size())
            throw InputError ("chart \"" + chart.title + "\"", "series \"" + series.name + "\" has "
                                                                   + std::to_string (series.x.size()) + " x values and "
                                                                   + std::to_string (series.y.size())
                                                                   + " y values; allowed: equal numbers of both");
}

void requireMatchingSizes (const BarChart& chart)
{
    for (const auto& series : chart.series)
        if (series.values.size() != static_cast<Eigen::Index> (chart.categories.size()))
            throw InputError ("chart \"" + chart.title + "\"",
                              "series \"" + series.name + "\" has " + std::to_string (series.values.size())
                                  + " values; allowed: one for each of the " + std::to_string (chart.categories.size())
                                  + " categories");
}
} // namespace antinode
