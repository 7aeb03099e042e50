#include "AnnotationDrawing.h"
#include "Curve.h"
#include "DataRange.h"
#include "Drawing.h"
#include "Legend.h"
#include "PlotFrame.h"

namespace antinode
{
namespace
{
AxisRange chosenX (const LineChart& chart)
{
    const auto range = chart.xRange ? *chart.xRange : xDataRange (chart).value_or (AxisRange {});
    return chart.logarithmicX ? positiveRange (range) : usableRange (range);
}

AxisRange chosenY (const LineChart& chart)
{
    if (! chart.yRange)
        return niceDataRange (yDataRange (chart), chart.logarithmicY);
    return chart.logarithmicY ? positiveRange (*chart.yRange) : usableRange (*chart.yRange);
}

CurvePiece toPixels (const Series& series, const PlotFrame& frame)
{
    CurvePiece points;
    points.reserve (static_cast<std::size_t> (series.x.size()));
    for (Eigen::Index k = 0; k < series.x.size(); ++k)
        points.push_back (frame.at (series.x[k], series.y[k]));
    return points;
}

void drawSeries (juce::Graphics& g, const PlotFrame& frame, const LineChart& chart, const Theme& theme)
{
    const juce::Graphics::ScopedSaveState state (g);
    // Half a line may stand over, so that a curve along the edge is as thick as elsewhere.
    g.reduceClipRegion (frame.plot.expanded (2).getSmallestIntegerContainer());
    const auto baseline = frame.y.logarithmic ? frame.plot.getBottom() : frame.yAt (0);
    for (std::size_t k = 0; k < chart.series.size(); ++k)
    {
        const auto& series = chart.series[k];
        const auto colour = seriesColour (theme, series.colour, k);
        const auto points = toPixels (series, frame);
        if (series.filled)
            fillBelowCurve (g, points, baseline, colour.withAlpha (0.16f));
        drawCurve (g, points, { colour, theme.lineWidth, series.style });
        if (series.points)
            drawDots (g, points, 3.2f * theme.lineWidth, colour);
    }
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const LineChart& chart, const Theme& theme)
{
    requireMatchingSizes (chart);
    auto rest = drawTitle (g, area, chart.title, theme);
    rest = drawLegend (g, rest, legendEntries (chart, theme), chart.legend, theme);
    const PlotMargins margins { heightAbove (chart.markers, chart.spans, theme), widthBeside (chart.limits, theme) };
    const auto frame = layOutPlot (rest, { chart.xLabel, chosenX (chart), chart.logarithmicX, {}, true },
                                   { chart.yLabel, chosenY (chart), chart.logarithmicY, {}, true }, margins, theme);
    drawGrid (g, frame, theme);
    drawSpans (g, frame, chart.spans, theme);
    drawMarkers (g, frame, chart.markers, markerRowBottom (frame, chart.spans, theme), theme);
    drawLimits (g, frame, chart.limits, theme);
    if (xDataRange (chart) && yDataRange (chart))
        drawSeries (g, frame, chart, theme);
    else
        drawNoData (g, frame, theme);
    drawAxes (g, frame, theme);
}
} // namespace antinode
