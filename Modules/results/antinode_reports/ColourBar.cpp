#include "ColourBar.h"

#include "Lettering.h"
#include "MapImage.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr auto gap = 14.0f, barWidth = 14.0f, tickRoom = 7.0f;

ChartAxis barAxis (const ChartAxis& axis, float height, const Theme& theme)
{
    return withTicks (axis, height, 2.6f * theme.tickHeight);
}

float widestTick (const ChartAxis& axis, const TextStyle& style)
{
    auto widest = 0.0f;
    for (const auto& tick : axis.ticks)
        widest = std::max (widest, textWidth (tick.label, style));
    return widest;
}
} // namespace

float colourBarWidth (const ChartAxis& axis, float height, const Theme& theme)
{
    const auto label = axis.label.empty() ? 0 : theme.labelHeight + 4;
    return gap + barWidth + tickRoom + widestTick (barAxis (axis, height, theme), { theme.tickHeight, false, {} })
           + label;
}

void drawColourBar (juce::Graphics& g, juce::Rectangle<float> area, const ChartAxis& given, const ColourMap& map,
                    const Theme& theme)
{
    const auto axis = barAxis (given, area.getHeight(), theme);
    const TextStyle style { theme.tickHeight, false, theme.mutedText };
    area.removeFromLeft (gap);
    const auto bar = area.removeFromLeft (barWidth);
    // Stretched as a whole: rows that were drawn one by one would show seams at odd scales.
    const Eigen::VectorXd shades = Eigen::VectorXd::LinSpaced (256, 0, 1);
    g.setOpacity (1);
    g.drawImage (colourImage (shades, { 0, 1 }, map), bar, juce::RectanglePlacement::stretchToFit);
    const auto widest = widestTick (axis, style);
    area.removeFromLeft (tickRoom);
    const auto labels = area.removeFromLeft (widest);
    for (const auto& tick : axis.ticks)
    {
        const auto y = bar.getBottom() - axis.fraction (tick.value) * bar.getHeight();
        g.setColour (theme.axis);
        drawHorizontal (g, y, bar.getRight(), bar.getRight() + 4);
        drawText (g, tick.label, labels.withY (y - style.height / 2).withHeight (style.height),
                  juce::Justification::centredLeft, style);
    }
    drawTextUpwards (g, axis.label, area.removeFromRight (theme.labelHeight), { theme.labelHeight, false, theme.text });
}
} // namespace antinode
