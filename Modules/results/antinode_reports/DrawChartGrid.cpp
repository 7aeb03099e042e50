#include "DataRange.h"
#include "Drawing.h"
#include "Legend.h"
#include "Lettering.h"
#include "PlotFrame.h"

#include <algorithm>
#include <cstdlib>

namespace antinode
{
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
