#include "AnnotationDrawing.h"
#include "DataRange.h"
#include "Drawing.h"
#include "Legend.h"
#include "PlotFrame.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace antinode
{
namespace
{
constexpr float groupShare = 0.78f;  // of the room of a category, for its bars
constexpr float minimumBarWidth = 2; // pixels at scale 1: the colours of thinner bars side by side mix in the eye

AxisRange chosenY (const BarChart& chart)
{
    if (! chart.yRange)
        return niceDataRange (yDataRange (chart), chart.logarithmic);
    return chart.logarithmic ? positiveRange (*chart.yRange) : usableRange (*chart.yRange);
}

ChartAxis categoryAxis (const BarChart& chart)
{
    ChartAxis axis {
        chart.xLabel, { -0.5, std::max (0.5, static_cast<double> (chart.categories.size()) - 0.5) }, false, {}, false
    };
    for (std::size_t k = 0; k < chart.categories.size(); ++k)
        axis.ticks.push_back ({ static_cast<double> (k), chart.categories[k] });
    if (axis.ticks.empty())
        axis.ticks.push_back ({ 0, "" });
    return axis;
}

/** Whole pixels: what begins and ends between them blends with its neighbours. */
class PixelGrid
{
public:
    explicit PixelGrid (juce::Graphics& g) : scale (g.getInternalContext().getPhysicalPixelScaleFactor()) {}

    float pixel() const { return 1 / scale; }
    float nearest (float length) const { return std::round (length * scale) / scale; }
    float below (float length) const { return std::floor (length * scale) / scale; }
    juce::Rectangle<float> nearest (juce::Rectangle<float> area) const
    {
        return juce::Rectangle<float>::leftTopRightBottom (nearest (area.getX()), nearest (area.getY()),
                                                           nearest (area.getRight()), nearest (area.getBottom()));
    }

private:
    float scale;
};

float baselineY (const PlotFrame& frame)
{
    return frame.y.logarithmic ? frame.plot.getBottom() : frame.yAt (0);
}

/** From the base to the value; empty if it has no place. */
juce::Rectangle<float> barRectangle (const PlotFrame& frame, float left, float width, double value)
{
    const auto y = frame.yAt (value), base = baselineY (frame);
    const auto top = std::min (y, base);
    return std::isfinite (y) ? juce::Rectangle<float> (left, top, width, std::max (y, base) - top)
                             : juce::Rectangle<float>();
}

float groupPitch (const PlotFrame& frame, const BarChart& chart)
{
    return frame.plot.getWidth() / static_cast<float> (chart.categories.size());
}

/** The bars of a category side by side. */
void drawGroups (juce::Graphics& g, const PlotFrame& frame, const BarChart& chart, const Theme& theme)
{
    const PixelGrid grid (g);
    const auto groupWidth = groupShare * groupPitch (frame, chart);
    const auto each = groupWidth / static_cast<float> (chart.series.size());
    const auto width = grid.below (each - std::min (1.0f, each * 0.1f));

    for (std::size_t s = 0; s < chart.series.size(); ++s)
    {
        const auto& series = chart.series[s];
        g.setColour (seriesColour (theme, series.colour, s));

        for (Eigen::Index k = 0; k < series.values.size(); ++k)
        {
            const auto left = frame.xAt (static_cast<double> (k)) - groupWidth / 2 + static_cast<float> (s) * each;
            g.fillRect (barRectangle (frame, grid.nearest (left), width, series.values[k]));
        }
    }
}

/** A series' bars over the whole width of their categories; where several share a column of pixels, what all of them
    cover. */
std::vector<juce::Rectangle<float>> columnRectangles (const PixelGrid& grid, const PlotFrame& frame,
                                                      const Eigen::VectorXd& values)
{
    std::vector<juce::Rectangle<float>> columns;

    for (Eigen::Index k = 0; k < values.size(); ++k)
    {
        const auto left = grid.nearest (frame.xAt (static_cast<double> (k) - 0.5));
        const auto room = grid.nearest (frame.xAt (static_cast<double> (k) + 0.5)) - left;
        const auto gap =
            room > 2.5f * grid.pixel() ? std::max (grid.pixel(), grid.nearest ((1 - groupShare) * room)) : 0;
        const auto bar = grid.nearest (barRectangle (frame, left, std::max (grid.pixel(), room - gap), values[k]));

        if (! columns.empty() && columns.back().getX() == bar.getX())
            columns.back() = columns.back().getUnion (bar);
        else
            columns.push_back (bar);
    }

    return columns;
}

/** The series over each other, in their order. Where one is covered its ends are drawn again, across the bars above it.
 */
void drawColumns (juce::Graphics& g, const PlotFrame& frame, const BarChart& chart, const Theme& theme)
{
    const PixelGrid grid (g);
    const auto endHeight = std::max (grid.pixel(), grid.nearest (theme.lineWidth));
    const auto base = grid.nearest (baselineY (frame));
    std::vector<std::vector<juce::Rectangle<float>>> columns;

    for (std::size_t s = 0; s < chart.series.size(); ++s)
    {
        columns.push_back (columnRectangles (grid, frame, chart.series[s].values));
        g.setColour (seriesColour (theme, chart.series[s].colour, s));

        for (const auto& column : columns.back())
            g.fillRect (column);
    }

    for (std::size_t s = 0; s + 1 < columns.size(); ++s)
    {
        g.setColour (seriesColour (theme, chart.series[s].colour, s));

        for (const auto& column : columns[s])
        {
            g.fillRect (column.withHeight (std::min (endHeight, std::max (0.0f, base - column.getY()))));
            g.fillRect (column.withTop (std::max (base, column.getBottom() - endHeight)));
        }
    }
}

void drawBars (juce::Graphics& g, const PlotFrame& frame, const BarChart& chart, const Theme& theme)
{
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (frame.plot.getSmallestIntegerContainer());

    if (groupShare * groupPitch (frame, chart) < minimumBarWidth * static_cast<float> (chart.series.size()))
        drawColumns (g, frame, chart, theme);
    else
        drawGroups (g, frame, chart, theme);
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const BarChart& chart, const Theme& theme)
{
    requireMatchingSizes (chart);
    auto rest = drawTitle (g, area, chart.title, theme);
    rest = drawLegend (g, rest, legendEntries (chart, theme), chart.legend, theme);
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
