#include "Drawing.h"
#include "MapOverlays.h"
#include "PlotFrame.h"

namespace antinode
{
namespace
{
PlotFrame makeFrame (const PlanView& chart, juce::Rectangle<float> rest, const Theme& theme)
{
    const auto hasScale = ! chart.yLabel.empty();
    const ChartAxis x { chart.xLabel, usableRange (chart.x), false, {}, false };
    ChartAxis y { chart.yLabel, usableRange (chart.y), false, {}, false };
    if (! hasScale)
        y.ticks.push_back ({ y.range.minimum, {} });
    const auto frame = layOutPlot (rest, x, y, {}, theme);
    return hasScale ? withEqualAspect (frame) : frame;
}

/** A band of hatching inside an edge: what holds it. */
void drawHeldEdge (juce::Graphics& g, const PlotFrame& frame, juce::Rectangle<float> band, const Theme& theme)
{
    constexpr float hatching = 6; // pixels between lines
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (band.getSmallestIntegerContainer());
    g.setColour (theme.axis);
    const auto reach = frame.plot.getHeight();
    const auto lines = static_cast<int> ((band.getWidth() + reach) / hatching) + 1;
    for (int i = 0; i < lines; ++i)
    {
        const auto x = band.getX() - reach + static_cast<float> (i) * hatching;
        g.drawLine (x, frame.plot.getBottom(), x + reach, frame.plot.getY(), theme.lineWidth);
    }
}

void drawHeldEdges (juce::Graphics& g, const PlotFrame& frame, const PlanView& chart, const Theme& theme)
{
    constexpr float depth = 7; // pixels
    if (chart.heldLeft)
        drawHeldEdge (g, frame, frame.plot.withWidth (depth), theme);
    if (chart.heldRight)
        drawHeldEdge (g, frame, frame.plot.withLeft (frame.plot.getRight() - depth), theme);
    if (chart.heldBottom)
        drawHeldEdge (g, frame, frame.plot.withTop (frame.plot.getBottom() - depth), theme);
    if (chart.heldTop)
        drawHeldEdge (g, frame, frame.plot.withHeight (depth), theme);
}
/** Hatching within the surface along parts of its outline that are held. */
void drawHeldPieces (juce::Graphics& g, const PlotFrame& frame, const PlanView& chart, const Theme& theme)
{
    constexpr float depth = 7, hatching = 5; // pixels
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (pathOf (chart.surface, frame));
    g.setColour (theme.axis);
    for (const auto& line : chart.heldPieces)
    {
        float rest = 0;
        for (std::size_t i = 1; i < line.size(); ++i)
        {
            const auto from = frame.at (line[i - 1].x(), line[i - 1].y()), to = frame.at (line[i].x(), line[i].y());
            const auto length = from.getDistanceFrom (to);
            const auto along = length > 0 ? (to - from) / length : juce::Point<float>();
            const auto first = hatching - rest;
            const auto ticks = length < first ? 0 : 1 + static_cast<int> ((length - first) / hatching);

            // A tick slants to both sides: that outside the surface is cut off.
            for (int tick = 0; tick < ticks; ++tick)
            {
                const auto at = from + along * (first + hatching * static_cast<float> (tick));
                const juce::Point<float> slant (0.7f * depth * (along.x + along.y), 0.7f * depth * (along.y - along.x));
                g.drawLine ({ at - slant, at + slant }, theme.lineWidth);
            }

            rest = length - (first + hatching * static_cast<float> (ticks - 1));
        }
    }
}
/** Springs within the surface along parts of its outline. */
void drawElasticPieces (juce::Graphics& g, const PlotFrame& frame, const PlanView& chart, const Theme& theme)
{
    constexpr float depth = 5, step = 4; // pixels: from the outline, and along it from turn to turn
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (pathOf (chart.surface, frame));
    g.setColour (theme.axis);
    for (const auto& line : chart.elasticPieces)
    {
        juce::Path outline, zigzag;
        for (std::size_t i = 0; i < line.size(); ++i)
            if (const auto at = frame.at (line[i].x(), line[i].y()); i == 0)
                outline.startNewSubPath (at);
            else
                outline.lineTo (at);
        const auto length = outline.getLength();
        const auto turns = static_cast<int> (length / step);
        for (int i = 0; i <= turns; ++i)
        {
            const auto from = step * static_cast<float> (i);
            const auto at = outline.getPointAlongPath (from);
            const auto along = outline.getPointAlongPath (std::min (from + 1, length))
                               - outline.getPointAlongPath (std::max (0.0f, from - 1));
            const auto side = (i % 2 == 0 ? depth : -depth) / std::max (1e-3f, along.getDistanceFromOrigin());
            const auto turn = at + juce::Point<float> (along.y, -along.x) * side;
            if (i == 0)
                zigzag.startNewSubPath (turn);
            else
                zigzag.lineTo (turn);
        }
        g.strokePath (zigzag, juce::PathStrokeType (theme.lineWidth));
    }
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const PlanView& chart, const Theme& theme)
{
    const auto frame = makeFrame (chart, drawTitle (g, area, chart.title, theme), theme);
    g.setColour (theme.axis);
    if (chart.surface.empty())
        g.drawRect (frame.plot, theme.lineWidth);
    drawSurface (g, frame, chart.surface, theme);
    drawHeldPieces (g, frame, chart, theme);
    drawElasticPieces (g, frame, chart, theme);
    drawHeldEdges (g, frame, chart, theme);
    g.setColour (theme.span);
    for (const auto& rectangle : chart.rectangles)
        if (rectangle.shape.empty())
            g.fillRect (juce::Rectangle<float> (frame.at (rectangle.xMinimum, rectangle.yMinimum),
                                                frame.at (rectangle.xMaximum, rectangle.yMaximum)));
        else
            g.fillPath (pathOf (rectangle.shape, frame));
    drawPlaces (g, frame, chart.rectangles, chart.points, theme);
    drawAxes (g, frame, theme);
}
} // namespace antinode
