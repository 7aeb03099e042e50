#include "CurveDrawing.h"

#include "AnnotationDrawing.h"
#include "Drawing.h"
#include "Lettering.h"
#include "PlotFrame.h"
#include "Ticks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
bool ascends (const CurvePiece& piece)
{
    return std::is_sorted (piece.begin(), piece.end(), [] (auto a, auto b) { return a.x < b.x; });
}

// On a logarithmic axis the same curve is dense at one end and sparse at the other.
bool haveNoGaps (const std::vector<CurveColumn>& columns, float columnWidth)
{
    const auto isWideStep = [=] (const auto& one, const auto& next) { return next.x - one.x > 1.5f * columnWidth; };
    return std::adjacent_find (columns.begin(), columns.end(), isWideStep) == columns.end();
}

// Without points that lie on the one before, as far as one can see: what remains has the same shape and is quick to
// stroke.
CurvePiece withoutRepeats (const CurvePiece& piece, float pixel)
{
    CurvePiece points;
    points.reserve (piece.size());
    for (const auto point : piece)
        if (points.empty() || point.getDistanceFrom (points.back()) > 0.25f * pixel)
            points.push_back (point);
    if (points.size() == 1)
        points.push_back (piece.back());
    return points;
}

juce::Path pathThrough (const CurvePiece& points)
{
    juce::Path path;
    path.preallocateSpace (static_cast<int> (3 * points.size()));
    path.startNewSubPath (points.front());
    for (std::size_t k = 1; k < points.size(); ++k)
        path.lineTo (points[k]);
    return path;
}

// Each column takes the extremes of its neighbours, up to half a line's width away: steep parts get the width of a
// line.
std::vector<CurveColumn> broadened (const std::vector<CurveColumn>& columns, std::size_t reach)
{
    auto broad = columns;
    for (std::size_t k = 0; k < columns.size(); ++k)
        for (auto other = k - std::min (k, reach); other < std::min (k + reach + 1, columns.size()); ++other)
        {
            broad[k].top = std::min (broad[k].top, columns[other].top);
            broad[k].bottom = std::max (broad[k].bottom, columns[other].bottom);
        }
    return broad;
}

// A band from the top to the bottom of each column: looks like the stroke of a dense curve and costs a tenth of it.
juce::Path band (const std::vector<CurveColumn>& columns, float width)
{
    juce::Path path;
    path.preallocateSpace (static_cast<int> (6 * columns.size()));
    path.startNewSubPath (columns.front().x, columns.front().top - width / 2);
    for (const auto& column : columns)
        path.lineTo (column.x, column.top - width / 2);
    for (auto column = columns.rbegin(); column != columns.rend(); ++column)
        path.lineTo (column->x, column->bottom + width / 2);
    path.closeSubPath();
    return path;
}

void strokePiece (juce::Graphics& g, const CurvePiece& piece, const CurveStyle& style)
{
    const juce::PathStrokeType stroke (style.width, juce::PathStrokeType::curved, juce::PathStrokeType::rounded);
    const auto path = pathThrough (piece);
    if (style.line == LineStyle::solid)
    {
        g.strokePath (path, stroke);
        return;
    }
    const juce::PathStrokeType butt (style.width, juce::PathStrokeType::curved, juce::PathStrokeType::butt);
    const auto unit = std::max (1.0f, style.width);
    const std::array<float, 2> lengths = style.line == LineStyle::dashed ? std::array { 4.5f * unit, 2.5f * unit }
                                                                         : std::array { 0.1f * unit, 2.0f * unit };
    juce::Path dashes;
    (style.line == LineStyle::dashed ? butt : stroke).createDashedStroke (dashes, path, lengths.data(), 2);
    g.fillPath (dashes);
}

void drawPiece (juce::Graphics& g, const CurvePiece& piece, const CurveStyle& style)
{
    if (piece.size() == 1)
        return drawDots (g, piece, 2 * style.width, style.colour);
    g.setColour (style.colour);
    const auto pixel = 1 / std::max (0.01f, g.getInternalContext().getPhysicalPixelScaleFactor());
    const auto pixelColumns = (piece.back().x - piece.front().x) / pixel;
    const auto isDense = static_cast<float> (piece.size()) > 2 * pixelColumns + 2;
    if (style.line != LineStyle::solid || ! isDense || ! ascends (piece))
        return strokePiece (g, withoutRepeats (piece, pixel), style);
    const auto columns = summariseColumns (piece, pixel);
    if (haveNoGaps (columns, pixel))
        g.fillPath (band (broadened (columns, static_cast<std::size_t> (0.5f * style.width / pixel)), style.width));
    else
        strokePiece (g, withoutRepeats (piece, pixel), style);
}
} // namespace

std::vector<CurvePiece> splitAtGaps (const CurvePiece& points)
{
    std::vector<CurvePiece> pieces;
    auto isOpen = false;
    for (const auto point : points)
    {
        const auto isFinite = point.isFinite();
        if (isFinite && ! isOpen)
            pieces.emplace_back();
        if (isFinite)
            pieces.back().push_back (point);
        isOpen = isFinite;
    }
    return pieces;
}

std::vector<CurveColumn> summariseColumns (const CurvePiece& piece, float columnWidth)
{
    std::vector<CurveColumn> columns;
    auto current = -1.0f;
    auto before = piece.empty() ? 0.0f : piece.front().y;
    for (const auto point : piece)
    {
        const auto index = std::floor ((point.x - piece.front().x) / columnWidth);
        if (index != current)
            columns.push_back ({ piece.front().x + (index + 0.5f) * columnWidth, before, before });
        current = index;
        before = point.y;
        columns.back().top = std::min (columns.back().top, point.y);
        columns.back().bottom = std::max (columns.back().bottom, point.y);
    }
    return columns;
}

void drawCurve (juce::Graphics& g, const CurvePiece& points, const CurveStyle& style)
{
    for (const auto& piece : splitAtGaps (points))
        drawPiece (g, piece, style);
}

void fillBelowCurve (juce::Graphics& g, const CurvePiece& points, float baseline, juce::Colour colour)
{
    g.setColour (colour);
    for (const auto& piece : splitAtGaps (points))
    {
        auto path = pathThrough (piece);
        path.lineTo (piece.back().x, baseline);
        path.lineTo (piece.front().x, baseline);
        path.closeSubPath();
        g.fillPath (path);
    }
}

void drawDots (juce::Graphics& g, const CurvePiece& points, float diameter, juce::Colour colour)
{
    g.setColour (colour);
    for (const auto point : points)
        if (point.isFinite())
            g.fillEllipse (juce::Rectangle<float> (diameter, diameter).withCentre (point));
}

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

namespace
{
constexpr auto laneGap = 8.0f;
constexpr int heightOfRest = 100, comfortableLane = 26;

void requireMatchingSizes (const StackedTraces& chart)
{
    const auto lanes = chart.values.rows();
    const auto names = static_cast<Eigen::Index> (chart.names.size());
    if (names != lanes || (chart.limits.size() != 0 && chart.limits.size() != lanes))
        throw InputError ("chart \"" + chart.title + "\"",
                          "has " + std::to_string (lanes) + " traces, " + std::to_string (names) + " names and "
                              + std::to_string (chart.limits.size())
                              + " limits; allowed: one name and one limit for each trace, or none");
}

AxisRange timeRange (const StackedTraces& chart)
{
    return usableRange (
        { chart.start,
          chart.start + chart.step * static_cast<double> (std::max<Eigen::Index> (1, chart.values.cols())) });
}

// Of each lane the value of largest magnitude, with its sign; 0 where nothing is finite.
Eigen::VectorXd lanePeaks (const Eigen::MatrixXd& values)
{
    Eigen::VectorXd peaks = Eigen::VectorXd::Zero (values.rows());
    for (const auto& sample : values.colwise())
        for (Eigen::Index lane = 0; lane < peaks.size(); ++lane)
            if (std::isfinite (sample[lane]) && std::abs (sample[lane]) > std::abs (peaks[lane]))
                peaks[lane] = sample[lane];
    return peaks;
}

double laneLimit (const StackedTraces& chart, Eigen::Index lane)
{
    const auto limit = chart.limits.size() > 0 ? chart.limits[lane] : 0.0;
    return std::isfinite (limit) ? std::max (0.0, limit) : 0.0;
}

// One scale for all: the largest peak, and the largest limit where that is not so far away that all would look flat.
double commonScale (const StackedTraces& chart, const Eigen::VectorXd& peaks)
{
    auto peak = 0.0, limit = 0.0;
    for (Eigen::Index lane = 0; lane < peaks.size(); ++lane)
    {
        peak = std::max (peak, std::abs (peaks[lane]));
        limit = std::max (limit, laneLimit (chart, lane));
    }
    const auto scale = limit > 4 * peak && peak > 0 ? peak : std::max (peak, limit);
    return scale > 0 ? scale : 1;
}

float widest (const std::vector<std::string>& texts, const TextStyle& style)
{
    auto width = 0.0f;
    for (const auto& text : texts)
        width = std::max (width, textWidth (text, style));
    return width;
}

struct Lanes
{
    PlotFrame frame;
    float height = 0;      ///< Of one lane.
    float nameWidth = 0;   ///< At the left of the plot.
    float peakWidth = 0;   ///< At the right of the plot.
    double scale = 1;      ///< The value that fills half a lane.
    Eigen::VectorXd peaks; ///< Of each lane.
    std::vector<std::string> peakTexts;
    std::size_t labelStride = 1; ///< Only every n-th lane has a name where they would touch.

    juce::Rectangle<float> at (Eigen::Index lane) const
    {
        return { frame.plot.getX(), frame.plot.getY() + static_cast<float> (lane) * height, frame.plot.getWidth(),
                 height };
    }

    float yAt (Eigen::Index lane, double value) const
    {
        const auto reach = std::clamp (value / scale, -1.1, 1.1);
        return at (lane).getCentreY() - static_cast<float> (reach) * 0.46f * height;
    }
};

Lanes layOutLanes (juce::Rectangle<float> rest, const StackedTraces& chart, const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, {} };
    Lanes result;
    result.peaks = lanePeaks (chart.values);
    for (const auto peak : result.peaks)
        result.peakTexts.push_back (formatNumber (peak) + " " + chart.unit);
    result.nameWidth = std::min (widest (chart.names, style), 0.25f * rest.getWidth());
    result.peakWidth = widest (result.peakTexts, style);
    result.scale = commonScale (chart, result.peaks);
    rest.removeFromLeft (result.nameWidth + laneGap);
    const PlotMargins margins { heightAbove (chart.markers, {}, theme), result.peakWidth + laneGap };
    // The y axis has no ticks of its own: the lanes have names instead.
    const ChartAxis laneAxis { {}, { 0, 1 }, false, { { 0, {} } }, false };
    result.frame = layOutPlot (rest, { chart.xLabel, timeRange (chart), false, {}, true }, laneAxis, margins, theme);
    const auto count = static_cast<float> (std::max<Eigen::Index> (1, chart.values.rows()));
    result.height = result.frame.plot.getHeight() / count;
    result.labelStride = static_cast<std::size_t> (std::ceil (0.95f * style.height / std::max (0.1f, result.height)));
    return result;
}

void drawLaneLimits (juce::Graphics& g, const Lanes& lanes, Eigen::Index lane, double limit, const Theme& theme)
{
    const auto area = lanes.at (lane);
    if (limit <= 0 || limit > 1.05 * lanes.scale || lanes.height < 10)
        return;
    for (const auto y : { lanes.yAt (lane, limit), lanes.yAt (lane, -limit) })
        drawCurve (g, { { area.getX(), y }, { area.getRight(), y } },
                   { theme.limit.withAlpha (0.65f), 0.9f, LineStyle::dashed });
}

void drawTrace (juce::Graphics& g, const Lanes& lanes, const StackedTraces& chart, Eigen::Index lane,
                const Theme& theme)
{
    CurvePiece points;
    points.reserve (static_cast<std::size_t> (chart.values.cols()));
    for (Eigen::Index k = 0; k < chart.values.cols(); ++k)
        points.emplace_back (lanes.frame.xAt (chart.start + chart.step * static_cast<double> (k)),
                             lanes.yAt (lane, chart.values (lane, k)));
    drawCurve (g, points,
               { theme.series.front(), std::min (theme.lineWidth, 0.75f + lanes.height / 40), LineStyle::solid });
}

void drawLabels (juce::Graphics& g, const Lanes& lanes, const StackedTraces& chart, Eigen::Index lane,
                 const Theme& theme)
{
    if (static_cast<std::size_t> (lane) % lanes.labelStride != 0)
        return;
    const auto limit = laneLimit (chart, lane);
    const auto isBeyond = limit > 0 && std::abs (lanes.peaks[lane]) > limit * (1 + 1e-9);
    const auto row = lanes.at (lane).withSizeKeepingCentre (lanes.frame.plot.getWidth(), theme.tickHeight);
    const auto left = row.withX (row.getX() - laneGap - lanes.nameWidth).withWidth (lanes.nameWidth);
    const auto right = row.withX (row.getRight() + laneGap).withWidth (lanes.peakWidth);
    drawText (g, chart.names[static_cast<std::size_t> (lane)], left, juce::Justification::centredRight,
              { theme.tickHeight, false, theme.text });
    drawText (g, lanes.peakTexts[static_cast<std::size_t> (lane)], right, juce::Justification::centredLeft,
              { theme.tickHeight, false, isBeyond ? theme.limit : theme.mutedText });
}

std::string makeCaption (const StackedTraces& chart)
{
    if (chart.limits.size() == 0 || ! (chart.limits.maxCoeff() > 0))
        return "peak at the right";
    const auto low = chart.limits.minCoeff(), high = chart.limits.maxCoeff();
    const auto inWords = [] (double limit)
    { return limit == std::round (limit) ? formatFixed (limit, 0) : formatNumber (limit); };
    const auto range = low == high ? inWords (high) : inWords (low) + " to " + inWords (high);
    return "limit ±" + range + " " + chart.unit + ", peak at the right";
}
} // namespace

int comfortableHeight (const StackedTraces& chart)
{
    return heightOfRest + comfortableLane * static_cast<int> (std::max<Eigen::Index> (3, chart.values.rows()));
}

void draw (juce::Graphics& g, juce::Rectangle<float> area, const StackedTraces& chart, const Theme& theme)
{
    requireMatchingSizes (chart);
    auto rest = drawTitle (g, area, chart.title, theme);
    const auto captionRow = rest.removeFromTop (theme.tickHeight * 1.3f);
    drawText (g, makeCaption (chart), captionRow, juce::Justification::centredLeft,
              { theme.tickHeight, false, theme.mutedText });
    const auto lanes = layOutLanes (rest, chart, theme);
    drawGrid (g, lanes.frame, theme);
    drawMarkers (g, lanes.frame, chart.markers, markerRowBottom (lanes.frame, {}, theme), theme);
    if (chart.values.size() == 0)
        drawNoData (g, lanes.frame, theme);
    const auto drawn = chart.values.size() == 0 ? 0 : chart.values.rows();
    for (Eigen::Index lane = 0; lane < drawn; ++lane)
    {
        g.setColour (theme.grid);
        drawHorizontal (g, lanes.at (lane).getBottom(), lanes.frame.plot.getX(), lanes.frame.plot.getRight());
        drawLaneLimits (g, lanes, lane, laneLimit (chart, lane), theme);
        drawTrace (g, lanes, chart, lane, theme);
        drawLabels (g, lanes, chart, lane, theme);
    }
    drawAxes (g, lanes.frame, theme);
}
} // namespace antinode
