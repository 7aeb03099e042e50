#include "Drawing.h"

#include "AnnotationDrawing.h"
#include "CurveDrawing.h"
#include "Lettering.h"
#include "PlotFrame.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace antinode
{
namespace
{
constexpr auto lineSwatch = 24.0f, barSwatch = 12.0f, swatchGap = 6.0f, entryGap = 18.0f;

TextStyle legendStyle (const Theme& theme)
{
    return { theme.tickHeight, false, theme.text };
}

float rowHeight (const Theme& theme)
{
    return theme.tickHeight * 1.4f;
}

float swatchWidth (const LegendEntry& entry)
{
    return entry.isBar ? barSwatch : lineSwatch;
}

float entryWidth (const LegendEntry& entry, const Theme& theme)
{
    return swatchWidth (entry) + swatchGap + textWidth (entry.name, legendStyle (theme));
}

void drawEntry (juce::Graphics& g, juce::Rectangle<float> row, const LegendEntry& entry, const Theme& theme)
{
    const auto swatch = row.removeFromLeft (swatchWidth (entry));
    if (entry.isBar)
    {
        g.setColour (entry.colour);
        g.fillRect (swatch.withSizeKeepingCentre (barSwatch, theme.tickHeight * 0.75f).toNearestInt().toFloat());
    }
    else
    {
        drawCurve (g, { { swatch.getX() + 1, swatch.getCentreY() }, { swatch.getRight() - 1, swatch.getCentreY() } },
                   { entry.colour, theme.lineWidth * 1.3f, entry.line });
    }
    row.removeFromLeft (swatchGap);
    drawText (g, entry.name, row, juce::Justification::centredLeft, legendStyle (theme));
}

juce::Rectangle<float> drawAbove (juce::Graphics& g, juce::Rectangle<float> area,
                                  const std::vector<LegendEntry>& entries, const Theme& theme)
{
    auto row = area.removeFromTop (rowHeight (theme));
    for (const auto& entry : entries)
    {
        const auto isFirst = row.getWidth() >= area.getWidth();
        if (! isFirst && entryWidth (entry, theme) > row.getWidth())
            row = area.removeFromTop (rowHeight (theme));
        drawEntry (g, row.removeFromLeft (std::min (entryWidth (entry, theme), row.getWidth())), entry, theme);
        row.removeFromLeft (entryGap);
    }
    area.removeFromTop (theme.tickHeight * 0.3f);
    return area;
}

juce::Rectangle<float> drawBeside (juce::Graphics& g, juce::Rectangle<float> area,
                                   const std::vector<LegendEntry>& entries, const Theme& theme)
{
    auto width = 0.0f;
    for (const auto& entry : entries)
        width = std::max (width, entryWidth (entry, theme));
    auto column = area.removeFromRight (std::min (width, area.getWidth() * 0.35f));
    area.removeFromRight (entryGap);
    for (const auto& entry : entries)
        drawEntry (g, column.removeFromTop (rowHeight (theme)), entry, theme);
    return area;
}
} // namespace

std::vector<LegendEntry> legendEntries (const LineChart& chart, const Theme& theme)
{
    std::vector<LegendEntry> entries;
    for (std::size_t k = 0; k < chart.series.size(); ++k)
        if (! chart.series[k].name.empty())
            entries.push_back ({ chart.series[k].name, seriesColour (theme, chart.series[k].colour, k),
                                 chart.series[k].style, false });
    return entries;
}

std::vector<LegendEntry> legendEntries (const BarChart& chart, const Theme& theme)
{
    std::vector<LegendEntry> entries;
    for (std::size_t k = 0; k < chart.series.size(); ++k)
        if (! chart.series[k].name.empty())
            entries.push_back (
                { chart.series[k].name, seriesColour (theme, chart.series[k].colour, k), LineStyle::solid, true });
    return entries;
}

juce::Rectangle<float> drawLegend (juce::Graphics& g, juce::Rectangle<float> area,
                                   const std::vector<LegendEntry>& entries, LegendPlace place, const Theme& theme)
{
    if (entries.empty() || place == LegendPlace::none)
        return area;
    return place == LegendPlace::top ? drawAbove (g, area, entries, theme) : drawBeside (g, area, entries, theme);
}

juce::Image blankImage (int width, int height, float scale, juce::Colour colour)
{
    const auto pixels = [scale] (int length)
    { return juce::jmax (1, juce::roundToInt (static_cast<float> (length) * scale)); };
    juce::Image image (juce::Image::RGB, pixels (width), pixels (height), false, juce::SoftwareImageType());
    image.clear (image.getBounds(), colour);
    return image;
}

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

namespace
{
std::optional<AxisRange> findYRange (const Panel& panel)
{
    if (const auto* lines = std::get_if<LineChart> (&panel))
        return yDataRange (*lines);
    if (const auto* bars = std::get_if<BarChart> (&panel))
        return yDataRange (*bars);
    return {};
}

bool isLogarithmic (const Panel& panel)
{
    const auto* lines = std::get_if<LineChart> (&panel);
    const auto* bars = std::get_if<BarChart> (&panel);
    return (lines != nullptr && lines->logarithmicY) || (bars != nullptr && bars->logarithmic);
}

std::vector<Panel> withSharedScale (std::vector<Panel> panels)
{
    std::optional<AxisRange> range;
    for (const auto& panel : panels)
        range = united (range, findYRange (panel));
    for (auto& panel : panels)
    {
        const auto nice = niceDataRange (range, isLogarithmic (panel));
        if (auto* lines = std::get_if<LineChart> (&panel))
            lines->yRange = lines->yRange.value_or (nice);
        if (auto* bars = std::get_if<BarChart> (&panel))
            bars->yRange = bars->yRange.value_or (nice);
    }
    return panels;
}

std::vector<Panel> withoutLegends (std::vector<Panel> panels)
{
    for (auto& panel : panels)
    {
        if (auto* lines = std::get_if<LineChart> (&panel))
            lines->legend = LegendPlace::none;
        if (auto* bars = std::get_if<BarChart> (&panel))
            bars->legend = LegendPlace::none;
    }
    return panels;
}

// Of the first panel that has one: others may be without data.
std::vector<LegendEntry> sharedLegend (const ChartGrid& grid, const Theme& theme)
{
    std::vector<LegendEntry> entries;
    for (auto panel = grid.panels.begin(); grid.sharedLegend && entries.empty() && panel != grid.panels.end(); ++panel)
    {
        if (const auto* lines = std::get_if<LineChart> (&*panel))
            entries = legendEntries (*lines, theme);
        if (const auto* bars = std::get_if<BarChart> (&*panel))
            entries = legendEntries (*bars, theme);
    }
    return entries;
}

std::vector<Panel> preparedPanels (const ChartGrid& grid)
{
    auto panels = grid.sharedScale ? withSharedScale (grid.panels) : grid.panels;
    return grid.sharedLegend ? withoutLegends (panels) : panels;
}

// The labels round the panels; gives the area that is left for them.
juce::Rectangle<float> drawSurround (juce::Graphics& g, juce::Rectangle<float> area, const ChartGrid& grid,
                                     const Theme& theme)
{
    const TextStyle label { theme.labelHeight, false, theme.text };
    const auto xLabel = area.removeFromBottom (grid.xLabel.empty() ? 0 : label.height + 4);
    const auto yLabel = area.removeFromLeft (grid.yLabel.empty() ? 0 : label.height + 4);
    drawTextUpwards (g, grid.yLabel, yLabel.withWidth (label.height), label);
    drawText (g, grid.xLabel, xLabel.withLeft (area.getX()), juce::Justification::centred, label);
    return area;
}

void drawHeadings (juce::Graphics& g, juce::Rectangle<float>& area, const ChartGrid& grid, int rows, const Theme& theme)
{
    const TextStyle style { theme.labelHeight, true, theme.text };
    auto top = area.removeFromTop (grid.columnTitles.empty() ? 0 : style.height + 4);
    auto left = area.removeFromLeft (grid.rowTitles.empty() ? 0 : style.height + 4);
    top.setLeft (area.getX());
    const auto cellWidth = area.getWidth() / static_cast<float> (std::max (1, grid.columns));
    const auto cellHeight = area.getHeight() / static_cast<float> (rows);
    for (const auto& title : grid.columnTitles)
        drawText (g, title, top.removeFromLeft (cellWidth), juce::Justification::centred, style);
    for (const auto& title : grid.rowTitles)
        drawTextUpwards (g, title, left.removeFromTop (cellHeight), style);
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const ChartGrid& grid, const Theme& theme)
{
    auto rest = drawTitle (g, area, grid.title, theme);
    rest = drawLegend (g, rest, sharedLegend (grid, theme), LegendPlace::top, theme);
    rest = drawSurround (g, rest, grid, theme);
    const auto panels = preparedPanels (grid);
    const auto columns = std::max (1, grid.columns);
    const auto rows = std::max (1, (static_cast<int> (panels.size()) + columns - 1) / columns);
    drawHeadings (g, rest, grid, rows, theme);
    if (panels.empty())
        drawText (g, "no data", rest, juce::Justification::centred, { theme.labelHeight, false, theme.mutedText });
    const auto width = rest.getWidth() / static_cast<float> (columns);
    const auto height = rest.getHeight() / static_cast<float> (rows);
    const auto small = compact (theme);
    for (std::size_t k = 0; k < panels.size(); ++k)
    {
        const auto [row, column] = std::div (static_cast<int> (k), columns);
        const juce::Rectangle<float> cell (rest.getX() + static_cast<float> (column) * width,
                                           rest.getY() + static_cast<float> (row) * height, width, height);
        std::visit ([&] (const auto& panel) { draw (g, cell, panel, small); }, panels[k]);
    }
}

void draw (juce::Graphics& g, juce::Rectangle<float> area, const Chart& chart, const Theme& theme)
{
    std::visit ([&] (const auto& one) { draw (g, area, one, theme); }, chart);
}
} // namespace antinode
