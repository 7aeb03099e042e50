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
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const PlanView& chart, const Theme& theme)
{
    const auto frame = makeFrame (chart, drawTitle (g, area, chart.title, theme), theme);
    g.setColour (theme.axis);
    g.drawRect (frame.plot, theme.lineWidth);
    drawHeldEdges (g, frame, chart, theme);
    g.setColour (theme.span);
    for (const auto& rectangle : chart.rectangles)
        g.fillRect (juce::Rectangle<float> (frame.at (rectangle.xMinimum, rectangle.yMinimum),
                                            frame.at (rectangle.xMaximum, rectangle.yMaximum)));
    drawPlaces (g, frame, chart.rectangles, chart.points, theme);
    drawAxes (g, frame, theme);
}
} // namespace antinode
