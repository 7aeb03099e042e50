#include "AnnotationDrawing.h"
#include "Curve.h"
#include "DataRange.h"
#include "Drawing.h"
#include "Lettering.h"
#include "Numbers.h"
#include "PlotFrame.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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
