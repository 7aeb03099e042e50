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
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const PlanView& chart, const Theme& theme)
{
    const auto frame = makeFrame (chart, drawTitle (g, area, chart.title, theme), theme);
    g.setColour (theme.axis);
    g.drawRect (frame.plot, theme.lineWidth);
    g.setColour (theme.span);
    for (const auto& rectangle : chart.rectangles)
        g.fillRect (juce::Rectangle<float> (frame.at (rectangle.xMinimum, rectangle.yMinimum),
                                            frame.at (rectangle.xMaximum, rectangle.yMaximum)));
    drawPlaces (g, frame, chart.rectangles, chart.points, theme);
    drawAxes (g, frame, theme);
}
} // namespace antinode
