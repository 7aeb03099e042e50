#include "PlotFrame.h"

#include "Lettering.h"
#include "Ticks.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr auto tickLength = 4.0f, labelGap = 4.0f;

int tickExponent (double powerOfTenValue)
{
    return static_cast<int> (std::lround (std::log10 (powerOfTenValue)));
}

// 0.01 to 1000 as they are, beyond that all as powers of ten.
std::vector<AxisTick> labelledDecades (const std::vector<double>& values)
{
    const auto isShort = [] (double value) { return tickExponent (value) >= -2 && tickExponent (value) <= 3; };
    const auto areShort = std::all_of (values.begin(), values.end(), isShort);
    std::vector<AxisTick> ticks;
    ticks.reserve (values.size());
    for (const auto value : values)
        ticks.push_back ({ value, areShort ? formatFixed (value, std::max (0, -tickExponent (value)))
                                           : "10" + superscript (tickExponent (value)) });
    return ticks;
}

float widestLabel (const ChartAxis& axis, const TextStyle& style)
{
    auto widest = 0.0f;
    for (const auto& tick : axis.ticks)
        widest = std::max (widest, textWidth (tick.label, style));
    return widest;
}

// Categories have given ticks: only every n-th is shown where all of them would touch.
ChartAxis withThinnedTicks (ChartAxis axis, float length, float labelLength)
{
    const auto needed = labelLength * static_cast<float> (axis.ticks.size());
    const auto stride = static_cast<std::size_t> (niceStep (std::max (1.0f, needed / std::max (1.0f, length)), 1));
    std::vector<AxisTick> kept;
    for (std::size_t k = 0; k < axis.ticks.size(); k += stride)
        kept.push_back (axis.ticks[k]);
    axis.ticks = kept;
    return axis;
}

ChartAxis withFittingTicks (const ChartAxis& axis, float length, const TextStyle& style)
{
    if (! axis.ticks.empty())
        return withThinnedTicks (axis, length, widestLabel (axis, style) + 6);
    auto fitted = withTicks (axis, length, 60);
    for (auto spacing = 80.0f; spacing < length && spacing < 2 * widestLabel (fitted, style) + 100; spacing += 20)
    {
        if ((widestLabel (fitted, style) + 12) * static_cast<float> (fitted.ticks.size()) <= length)
            break;
        fitted = withTicks (axis, length, spacing);
    }
    return fitted;
}

float labelHeight (const std::string& label, const Theme& theme)
{
    return label.empty() ? 0 : theme.labelHeight + labelGap;
}

float snapped (juce::Graphics& g, float position)
{
    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();
    return std::round (position * scale) / scale;
}

void drawXLabels (juce::Graphics& g, const PlotFrame& frame, const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, theme.mutedText };
    const auto top = frame.plot.getBottom() + tickLength + 1;
    for (const auto& tick : frame.x.ticks)
    {
        const auto width = textWidth (tick.label, style) + 2;
        const auto middle = frame.xAt (tick.value);
        drawText (g, tick.label, { middle - width / 2, top, width, style.height }, juce::Justification::centred, style);
    }
    const auto bottom = top + theme.tickHeight + labelGap;
    drawText (g, frame.x.label, { frame.plot.getX(), bottom, frame.plot.getWidth(), theme.labelHeight },
              juce::Justification::centred, { theme.labelHeight, false, theme.text });
}

void drawYLabels (juce::Graphics& g, const PlotFrame& frame, const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, theme.mutedText };
    const auto width = widestLabel (frame.y, style) + 2;
    const auto right = frame.plot.getX() - tickLength - 2;
    for (const auto& tick : frame.y.ticks)
    {
        const auto top = frame.yAt (tick.value) - style.height / 2;
        drawText (g, tick.label, { right - width, top, width, style.height }, juce::Justification::centredRight, style);
    }
    const auto labelRight = right - width - labelGap;
    drawTextUpwards (g, frame.y.label,
                     { labelRight - theme.labelHeight, frame.plot.getY(), theme.labelHeight, frame.plot.getHeight() },
                     { theme.labelHeight, false, theme.text });
}
} // namespace

float ChartAxis::fraction (double value) const
{
    constexpr auto furthest = 20.0;
    if (logarithmic && ! (value > 0))
        return std::numeric_limits<float>::quiet_NaN();
    const auto scaled = [&] (double v) { return logarithmic ? std::log10 (v) : v; };
    const auto low = scaled (range.minimum);
    const auto position = (scaled (value) - low) / (scaled (range.maximum) - low);
    if (! std::isfinite (value))
        return std::numeric_limits<float>::quiet_NaN();
    return static_cast<float> (std::clamp (position, -furthest, 1 + furthest));
}

AxisRange positiveRange (AxisRange range)
{
    // Powers of ten below this would be 0.
    constexpr auto smallest = 1e-150;
    const auto [low, high] = usableRange (range);
    if (high < 1e6 * smallest)
        return { 0.1, 1 };
    const auto minimum = low > 0 ? std::max (low, smallest) : high * 1e-6;
    return high < 1.001 * minimum ? AxisRange { minimum / 2, minimum * 2 } : AxisRange { minimum, high };
}

ChartAxis withTicks (ChartAxis axis, float length, float spacing)
{
    axis.ticks.clear();
    const auto maximumTicks = std::max (1, static_cast<int> (length / spacing));
    if (axis.logarithmic)
    {
        axis.ticks = labelledDecades (decadeTicks (axis.range, maximumTicks));
        return axis;
    }
    const auto exponent = commonExponent (axis.range);
    const auto values = linearTicks (axis.range, maximumTicks);
    const auto labels = tickLabels (values, exponent);
    for (std::size_t k = 0; k < values.size(); ++k)
        axis.ticks.push_back ({ values[k], labels[k] });
    if (exponent != 0)
        axis.label += "  " + powerOfTen (exponent);
    return axis;
}

PlotFrame layOutPlot (juce::Rectangle<float> area, ChartAxis x, ChartAxis y, PlotMargins margins, const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, theme.mutedText };
    area.removeFromTop (std::max (margins.above, theme.tickHeight / 2));
    area.removeFromBottom (tickLength + 1 + theme.tickHeight + labelHeight (x.label, theme));
    y = y.ticks.empty() ? withTicks (y, area.getHeight(), 2.6f * theme.tickHeight)
                        : withThinnedTicks (y, area.getHeight(), 1.1f * theme.tickHeight);
    area.removeFromLeft (tickLength + 4 + widestLabel (y, style) + labelHeight (y.label, theme));
    area.removeFromRight (margins.right);
    x = withFittingTicks (x, area.getWidth(), style);
    // Half of the last label may hang over.
    if (! x.ticks.empty())
    {
        const auto half = textWidth (x.ticks.back().label, style) / 2;
        const auto over = (x.fraction (x.ticks.back().value) - 1) * area.getWidth() + half - margins.right;
        area.removeFromRight (std::max (0.0f, over));
    }
    return { area.toNearestInt().toFloat(), std::move (x), std::move (y) };
}

PlotFrame withEqualAspect (PlotFrame frame)
{
    const auto perUnit = std::min (frame.plot.getWidth() / (frame.x.range.maximum - frame.x.range.minimum),
                                   frame.plot.getHeight() / (frame.y.range.maximum - frame.y.range.minimum));
    const auto width = static_cast<float> (perUnit * (frame.x.range.maximum - frame.x.range.minimum));
    const auto height = static_cast<float> (perUnit * (frame.y.range.maximum - frame.y.range.minimum));
    frame.plot = frame.plot.withSizeKeepingCentre (width, height).toNearestInt().toFloat();
    return frame;
}

void drawGrid (juce::Graphics& g, const PlotFrame& frame, const Theme& theme)
{
    g.setColour (theme.plotBackground);
    g.fillRect (frame.plot);
    g.setColour (theme.grid);
    if (frame.x.grid)
        for (const auto& tick : frame.x.ticks)
            drawVertical (g, frame.xAt (tick.value), frame.plot.getY(), frame.plot.getBottom());
    if (frame.y.grid)
        for (const auto& tick : frame.y.ticks)
            drawHorizontal (g, frame.yAt (tick.value), frame.plot.getX(), frame.plot.getRight());
    g.setColour (theme.axis);
    if (! frame.y.logarithmic && frame.y.range.minimum < 0 && frame.y.range.maximum > 0)
        drawHorizontal (g, frame.yAt (0), frame.plot.getX(), frame.plot.getRight());
}

void drawAxes (juce::Graphics& g, const PlotFrame& frame, const Theme& theme)
{
    g.setColour (theme.axis);
    drawHorizontal (g, frame.plot.getBottom(), frame.plot.getX(), frame.plot.getRight());
    drawVertical (g, frame.plot.getX(), frame.plot.getY(), frame.plot.getBottom());
    for (const auto& tick : frame.x.ticks)
        drawVertical (g, frame.xAt (tick.value), frame.plot.getBottom(), frame.plot.getBottom() + tickLength);
    for (const auto& tick : frame.y.ticks)
        drawHorizontal (g, frame.yAt (tick.value), frame.plot.getX() - tickLength, frame.plot.getX());
    drawXLabels (g, frame, theme);
    drawYLabels (g, frame, theme);
}

void drawNoData (juce::Graphics& g, const PlotFrame& frame, const Theme& theme)
{
    g.setColour (theme.plotBackground);
    g.fillRect (frame.plot);
    drawText (g, "no data", frame.plot, juce::Justification::centred, { theme.labelHeight, false, theme.mutedText });
}

juce::Rectangle<float> drawTitle (juce::Graphics& g, juce::Rectangle<float> area, const std::string& title,
                                  const Theme& theme)
{
    g.setColour (theme.background);
    g.fillRect (area);
    auto rest = area.reduced (theme.padding);
    if (title.empty())
        return rest;
    const auto row = rest.removeFromTop (theme.titleHeight);
    drawText (g, title, row, juce::Justification::centredLeft, { theme.titleHeight, theme.boldTitle, theme.text });
    rest.removeFromTop (theme.titleHeight * 0.4f);
    return rest;
}

void drawHorizontal (juce::Graphics& g, float y, float fromX, float toX, float thickness)
{
    g.fillRect (juce::Rectangle<float> (fromX, snapped (g, y - thickness / 2), toX - fromX, thickness));
}

void drawVertical (juce::Graphics& g, float x, float fromY, float toY, float thickness)
{
    g.fillRect (juce::Rectangle<float> (snapped (g, x - thickness / 2), fromY, thickness, toY - fromY));
}

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
