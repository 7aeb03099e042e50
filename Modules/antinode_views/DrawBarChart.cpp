#include "AnnotationDrawing.h"
#include "DataRange.h"
#include "Drawing.h"
#include "Legend.h"
#include "PlotFrame.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
AxisRange chosenY (const BarChart& chart)
{
    if (! chart.yRange)
        return niceDataRange (yDataRange (chart), chart.logarithmic);
    return chart.logarithmic ? positiveRange (*chart.yRange) : usableRange (*chart.yRange);
}

Axis categoryAxis (const BarChart& chart)
{
    Axis axis {
        chart.xLabel, { -0.5, std::max (0.5, static_cast<double> (chart.categories.size()) - 0.5) }, false, {}, false
    };
    for (std::size_t k = 0; k < chart.categories.size(); ++k)
        axis.ticks.push_back ({ static_cast<double> (k), chart.categories[k] });
    if (axis.ticks.empty())
        axis.ticks.push_back ({ 0, "" });
    return axis;
}

void drawBar (juce::Graphics& g, const PlotFrame& frame, float left, float width, double value)
{
    const auto y = frame.yAt (value);
    if (! std::isfinite (y))
        return;
    const auto base = frame.y.logarithmic ? frame.plot.getBottom() : frame.yAt (0);
    const auto top = std::min (y, base);
    g.fillRect (juce::Rectangle<float> (left, top, width, std::max (y, base) - top));
}

void drawBars (juce::Graphics& g, const PlotFrame& frame, const BarChart& chart, const Theme& theme)
{
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (frame.plot.getSmallestIntegerContainer());
    const auto groupWidth = 0.78f * frame.plot.getWidth() / static_cast<float> (chart.categories.size());
    const auto width = groupWidth / static_cast<float> (chart.series.size());
    for (std::size_t s = 0; s < chart.series.size(); ++s)
    {
        const auto& series = chart.series[s];
        g.setColour (seriesColour (theme, series.colour, s));
        for (Eigen::Index k = 0; k < series.values.size(); ++k)
        {
            const auto left = frame.xAt (static_cast<double> (k)) - groupWidth / 2 + static_cast<float> (s) * width;
            drawBar (g, frame, left, std::max (0.5f, width - std::min (1.0f, width * 0.1f)), series.values[k]);
        }
    }
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const BarChart& chart, const Theme& theme)
{
    requireMatchingSizes (chart);
    auto rest = drawTitle (g, area, chart.title, theme);
    rest = drawLegend (g, rest, legendOf (chart, theme), chart.legend, theme);
    const auto frame =
        layOutPlot (rest, categoryAxis (chart), { chart.yLabel, chosenY (chart), chart.logarithmic, {}, true },
                    { 0, widthBeside (chart.limits, theme) }, theme);
    drawGrid (g, frame, theme);
    if (yDataRange (chart) && ! chart.categories.empty() && ! chart.series.empty())
        drawBars (g, frame, chart, theme);
    else
        drawNoData (g, frame, theme);
    drawLimits (g, frame, chart.limits, theme);
    drawAxes (g, frame, theme);
}
} // namespace antinode
