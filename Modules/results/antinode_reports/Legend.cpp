#include "Legend.h"

#include "Curve.h"
#include "Lettering.h"

#include <algorithm>

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
} // namespace antinode
