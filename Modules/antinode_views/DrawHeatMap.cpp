#include "AnnotationDrawing.h"
#include "ColourBar.h"
#include "Curve.h"
#include "DataRange.h"
#include "Drawing.h"
#include "Lettering.h"
#include "MapImage.h"
#include "PlotFrame.h"

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
    const auto most = std::max (std::abs (range.minimum), std::abs (range.maximum));
    return { -most, most };
}

void drawMap (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, AxisRange range, const ColourMap& map)
{
    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();
    const auto columns = std::max (1, juce::roundToInt (frame.plot.getWidth() * scale));
    const auto rows = std::max (1, juce::roundToInt (frame.plot.getHeight() * scale));
    g.setOpacity (1);
    g.drawImage (colourImage (resampled (chart.values, rows, columns), range, map), frame.plot,
                 juce::RectanglePlacement::stretchToFit);
}

// Lines and labels over a map stand on a halo of the page's colour: legible on every colour.
void drawWithHalo (juce::Graphics& g, const CurvePiece& line, const Theme& theme)
{
    drawCurve (g, line, { theme.background.withAlpha (0.7f), 3.4f, LineStyle::solid });
    drawCurve (g, line, { theme.text, 1.3f, LineStyle::solid });
}

void drawTag (juce::Graphics& g, const std::string& label, juce::Point<float> centre, const Theme& theme)
{
    if (label.empty())
        return;
    const TextStyle style { theme.tickHeight, false, theme.text };
    const auto tag = juce::Rectangle<float> (textWidth (label, style) + 6, style.height + 1).withCentre (centre);
    g.setColour (theme.background.withAlpha (0.75f));
    g.fillRoundedRectangle (tag, 3);
    drawText (g, label, tag, juce::Justification::centred, style);
}

void drawRectangle (juce::Graphics& g, const PlotFrame& frame, const MapRectangle& rectangle, const Theme& theme)
{
    const auto one = frame.at (rectangle.xMinimum, rectangle.yMinimum);
    const auto other = frame.at (rectangle.xMaximum, rectangle.yMaximum);
    if (! one.isFinite() || ! other.isFinite())
        return;
    drawWithHalo (g, { one, { other.x, one.y }, other, { one.x, other.y }, one }, theme);
    const auto fits = textWidth (rectangle.label, { theme.tickHeight, false, {} }) + 6 <= std::abs (other.x - one.x)
                      && theme.tickHeight + 1 <= std::abs (other.y - one.y);
    if (fits)
        drawTag (g, rectangle.label, (one + other) / 2.0f, theme);
}

void drawPoint (juce::Graphics& g, const PlotFrame& frame, const MapPoint& point, const Theme& theme)
{
    constexpr auto arm = 7.0f;
    const auto centre = frame.at (point.x, point.y);
    if (! centre.isFinite())
        return;
    drawWithHalo (g, { centre.translated (-arm, 0), centre.translated (arm, 0) }, theme);
    drawWithHalo (g, { centre.translated (0, -arm), centre.translated (0, arm) }, theme);
    const auto width = textWidth (point.label, { theme.tickHeight, false, {} });
    const auto side = centre.x + arm + width + 10 < frame.plot.getRight() ? 1.0f : -1.0f;
    drawTag (g, point.label, centre.translated (side * (arm + 5 + width / 2), -arm), theme);
}

void drawOverlays (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, const Theme& theme)
{
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (frame.plot.getSmallestIntegerContainer());
    for (const auto& rectangle : chart.rectangles)
        drawRectangle (g, frame, rectangle, theme);
    for (const auto& point : chart.points)
        drawPoint (g, frame, point, theme);
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const HeatMap& chart, const Theme& theme)
{
    const auto rest = drawTitle (g, area, chart.title, theme);
    const auto range = chosenValues (chart);
    const auto& map = chart.scale == ColourScale::sequential ? theme.sequential : theme.diverging;
    const Axis values { chart.valueLabel, range, false, {}, false };
    const auto barWidth = colourBarWidth (values, rest.getHeight(), theme);
    const PlotMargins margins { heightAbove (chart.markers, {}, theme), barWidth };
    auto frame = layOutPlot (rest, { chart.xLabel, usableRange (chart.x), false, {}, false },
                             { chart.yLabel, usableRange (chart.y), false, {}, false }, margins, theme);
    if (chart.equalAspect)
        frame = withEqualAspect (frame);
    drawGrid (g, frame, theme);
    if (dataRange (chart))
        drawMap (g, frame, chart, range, map);
    else
        drawNoData (g, frame, theme);
    drawMarkers (g, frame, chart.markers, markerRowBottom (frame, {}, theme), theme);
    drawOverlays (g, frame, chart, theme);
    drawAxes (g, frame, theme);
    drawColourBar (g, frame.plot.withX (frame.plot.getRight()).withWidth (barWidth), values, map, theme);
}
} // namespace antinode
