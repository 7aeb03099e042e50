#include "AnnotationDrawing.h"
#include "ColourBar.h"
#include "DataRange.h"
#include "Drawing.h"
#include "MapImage.h"
#include "MapOverlays.h"
#include "PlotFrame.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
std::optional<AxisRange> dataRange (const HeatMap& chart)
{
    return including ({}, Eigen::Map<const Eigen::VectorXd> (chart.values.data(), chart.values.size()));
}

AxisRange chosenValues (const HeatMap& chart)
{
    const auto range = usableRange (chart.valueRange ? *chart.valueRange : dataRange (chart).value_or (AxisRange {}));
    if (chart.scale == ColourScale::sequential)
        return range;
    const auto maximum = std::max (std::abs (range.minimum), std::abs (range.maximum));
    return { -maximum, maximum };
}

void drawMap (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, AxisRange range, const ColourMap& map)
{
    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();
    const auto columns = std::max (1, juce::roundToInt (frame.plot.getWidth() * scale));
    const auto rows = std::max (1, juce::roundToInt (frame.plot.getHeight() * scale));
    const juce::Graphics::ScopedSaveState state (g);
    if (! chart.surface.empty())
        g.reduceClipRegion (pathOf (chart.surface, frame));
    g.setOpacity (1);
    const auto isTable = ! chart.columnNames.empty() || ! chart.rowNames.empty();
    const auto pixels = isTable ? repeated (chart.values, rows, columns) : resampled (chart.values, rows, columns);
    g.drawImage (colourImage (pixels, range, map), frame.plot, juce::RectanglePlacement::stretchToFit);
}

void drawOverlays (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, const Theme& theme)
{
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (frame.plot.getSmallestIntegerContainer());
    {
        const juce::Graphics::ScopedSaveState onSurface (g);
        if (! chart.surface.empty())
            g.reduceClipRegion (pathOf (chart.surface, frame));
        drawContours (g, frame, chart, theme);
    }
    drawSurface (g, frame, chart.surface, theme);
    drawPlaces (g, frame, chart.rectangles, chart.points, theme);
}

// Names stand at the middles of the cells, which a table numbers from 0.
ChartAxis makeAxis (const std::string& label, AxisRange range, const std::vector<std::string>& names)
{
    if (names.empty())
        return { label, usableRange (range), false, {}, false };
    ChartAxis axis { label, { -0.5, static_cast<double> (names.size()) - 0.5 }, false, {}, false };
    for (std::size_t k = 0; k < names.size(); ++k)
        axis.ticks.push_back ({ static_cast<double> (k), names[k] });
    return axis;
}

void requireMatchingSizes (const HeatMap& chart)
{
    const auto columns = static_cast<Eigen::Index> (chart.columnNames.size());
    const auto rows = static_cast<Eigen::Index> (chart.rowNames.size());
    if ((columns != 0 && columns != chart.values.cols()) || (rows != 0 && rows != chart.values.rows()))
        throw InputError ("chart \"" + chart.title + "\"", "has " + std::to_string (chart.values.rows()) + " rows and "
                                                               + std::to_string (chart.values.cols()) + " columns, "
                                                               + std::to_string (rows) + " row names and "
                                                               + std::to_string (columns)
                                                               + " column names; allowed: one name for each, or none");
}

PlotFrame makeFrame (const HeatMap& chart, juce::Rectangle<float> rest, float barWidth, const Theme& theme)
{
    const auto x = makeAxis (chart.xLabel, chart.x, chart.columnNames);
    const auto y = makeAxis (chart.yLabel, chart.y, chart.rowNames);
    const auto frame = chart.isBare
                           ? PlotFrame { rest, x, y }
                           : layOutPlot (rest, x, y, { heightAbove (chart.markers, {}, theme), barWidth }, theme);
    return chart.equalAspect ? withEqualAspect (frame) : frame;
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const HeatMap& chart, const Theme& theme)
{
    requireMatchingSizes (chart);
    const auto rest = drawTitle (g, area, chart.title, theme);
    const auto range = chosenValues (chart);
    const auto& map = chart.scale == ColourScale::sequential ? theme.sequential : theme.diverging;
    const ChartAxis values { chart.valueLabel, range, false, {}, false };
    const auto barWidth = chart.isBare ? 0 : colourBarWidth (values, rest.getHeight(), theme);
    const auto frame = makeFrame (chart, rest, barWidth, theme);
    if (chart.surface.empty()) // Lines would show in holes.
        drawGrid (g, frame, theme);
    if (dataRange (chart))
        drawMap (g, frame, chart, range, map);
    else
        drawNoData (g, frame, theme);
    drawMarkers (g, frame, chart.markers, markerRowBottom (frame, {}, theme), theme);
    drawOverlays (g, frame, chart, theme);
    if (chart.isBare && ! chart.surface.empty())
        return;
    if (chart.isBare)
    {
        g.setColour (theme.axis);
        g.drawRect (frame.plot, 1);
        return;
    }
    drawAxes (g, frame, theme);
    drawColourBar (g, frame.plot.withX (frame.plot.getRight()).withWidth (barWidth), values, map, theme);
}
} // namespace antinode
