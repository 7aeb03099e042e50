#include "MapDrawing.h"

#include "AnnotationDrawing.h"
#include "Drawing.h"
#include "Lettering.h"
#include "MapOverlays.h"
#include "PlotFrame.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
Eigen::MatrixXd averagedRows (const Eigen::MatrixXd& values, int rows)
{
    Eigen::MatrixXd averaged (rows, values.cols());
    for (int k = 0; k < rows; ++k)
    {
        const auto first = k * values.rows() / rows;
        const auto last = (k + 1) * values.rows() / rows;
        averaged.row (k) = values.middleRows (first, last - first).colwise().mean();
    }
    return averaged;
}

Eigen::MatrixXd interpolatedRows (const Eigen::MatrixXd& values, int rows)
{
    Eigen::MatrixXd interpolated (rows, values.cols());
    const auto last = values.rows() - 1;
    for (int k = 0; k < rows; ++k)
    {
        const auto place = (k + 0.5) * static_cast<double> (values.rows()) / rows - 0.5;
        const auto inside = std::clamp (place, 0.0, static_cast<double> (last));
        const auto lower = static_cast<Eigen::Index> (inside);
        const auto share = inside - static_cast<double> (lower);
        interpolated.row (k) = (1 - share) * values.row (lower) + share * values.row (std::min (lower + 1, last));
    }
    return interpolated;
}

Eigen::MatrixXd withRows (const Eigen::MatrixXd& values, int rows)
{
    return values.rows() > rows ? averagedRows (values, rows) : interpolatedRows (values, rows);
}
} // namespace

Eigen::MatrixXd resampled (const Eigen::MatrixXd& values, int rows, int columns)
{
    const Eigen::MatrixXd turned = withRows (values, rows).transpose();
    return withRows (turned, columns).transpose();
}

Eigen::MatrixXd repeated (const Eigen::MatrixXd& values, int rows, int columns)
{
    return Eigen::MatrixXd::NullaryExpr (
        rows, columns,
        [&] (Eigen::Index row, Eigen::Index column)
        { return values (row * values.rows() / rows, column * values.cols() / columns); });
}

juce::Image colourImage (const Eigen::MatrixXd& pixels, AxisRange range, const ColourMap& map)
{
    const auto width = static_cast<int> (pixels.cols());
    const auto height = static_cast<int> (pixels.rows());
    juce::Image image (juce::Image::ARGB, width, height, true, juce::SoftwareImageType());
    const juce::Image::BitmapData data (image, juce::Image::BitmapData::writeOnly);
    const auto factor = 1 / (range.maximum - range.minimum);
    for (int x = 0; x < width; ++x)
    {
        checkWatch();
        for (int y = 0; y < height; ++y)
        {
            const auto value = pixels (height - 1 - y, x);
            if (std::isfinite (value))
                data.setPixelColour (x, y, map.at ((value - range.minimum) * factor));
        }
    }
    return image;
}

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
    const auto maximum = std::max (std::abs (range.minimum), std::abs (range.maximum));
    return { -maximum, maximum };
}

void drawMap (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, AxisRange range, const ColourMap& map)
{
    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();
    const auto columns = std::max (1, juce::roundToInt (frame.plot.getWidth() * scale));
    const auto rows = std::max (1, juce::roundToInt (frame.plot.getHeight() * scale));
    const juce::Graphics::ScopedSaveState state (g);
    if (! chart.surface.empty())
        g.reduceClipRegion (pathOf (chart.surface, frame));
    g.setOpacity (1);
    const auto isTable = ! chart.columnNames.empty() || ! chart.rowNames.empty();
    const auto pixels = isTable ? repeated (chart.values, rows, columns) : resampled (chart.values, rows, columns);
    g.drawImage (colourImage (pixels, range, map), frame.plot, juce::RectanglePlacement::stretchToFit);
}

void drawOverlays (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, const Theme& theme)
{
    const juce::Graphics::ScopedSaveState state (g);
    g.reduceClipRegion (frame.plot.getSmallestIntegerContainer());
    {
        const juce::Graphics::ScopedSaveState onSurface (g);
        if (! chart.surface.empty())
            g.reduceClipRegion (pathOf (chart.surface, frame));
        drawContours (g, frame, chart, theme);
    }
    drawSurface (g, frame, chart.surface, theme);
    drawPlaces (g, frame, chart.rectangles, chart.points, theme);
}

// Names stand at the middles of the cells, which a table numbers from 0.
ChartAxis makeAxis (const std::string& label, AxisRange range, const std::vector<std::string>& names)
{
    if (names.empty())
        return { label, usableRange (range), false, {}, false };
    ChartAxis axis { label, { -0.5, static_cast<double> (names.size()) - 0.5 }, false, {}, false };
    for (std::size_t k = 0; k < names.size(); ++k)
        axis.ticks.push_back ({ static_cast<double> (k), names[k] });
    return axis;
}

void requireMatchingSizes (const HeatMap& chart)
{
    const auto columns = static_cast<Eigen::Index> (chart.columnNames.size());
    const auto rows = static_cast<Eigen::Index> (chart.rowNames.size());
    if ((columns != 0 && columns != chart.values.cols()) || (rows != 0 && rows != chart.values.rows()))
        throw InputError ("chart \"" + chart.title + "\"", "has " + std::to_string (chart.values.rows()) + " rows and "
                                                               + std::to_string (chart.values.cols()) + " columns, "
                                                               + std::to_string (rows) + " row names and "
                                                               + std::to_string (columns)
                                                               + " column names; allowed: one name for each, or none");
}

PlotFrame makeFrame (const HeatMap& chart, juce::Rectangle<float> rest, float barWidth, const Theme& theme)
{
    const auto x = makeAxis (chart.xLabel, chart.x, chart.columnNames);
    const auto y = makeAxis (chart.yLabel, chart.y, chart.rowNames);
    const auto frame = chart.isBare
                           ? PlotFrame { rest, x, y }
                           : layOutPlot (rest, x, y, { heightAbove (chart.markers, {}, theme), barWidth }, theme);
    return chart.equalAspect ? withEqualAspect (frame) : frame;
}
} // namespace

void draw (juce::Graphics& g, juce::Rectangle<float> area, const HeatMap& chart, const Theme& theme)
{
    requireMatchingSizes (chart);
    const auto rest = drawTitle (g, area, chart.title, theme);
    const auto range = chosenValues (chart);
    const auto& map = chart.scale == ColourScale::sequential ? theme.sequential : theme.diverging;
    const ChartAxis values { chart.valueLabel, range, false, {}, false };
    const auto barWidth = chart.isBare ? 0 : colourBarWidth (values, rest.getHeight(), theme);
    const auto frame = makeFrame (chart, rest, barWidth, theme);
    if (chart.surface.empty()) // Lines would show in holes.
        drawGrid (g, frame, theme);
    if (dataRange (chart))
        drawMap (g, frame, chart, range, map);
    else
        drawNoData (g, frame, theme);
    drawMarkers (g, frame, chart.markers, markerRowBottom (frame, {}, theme), theme);
    drawOverlays (g, frame, chart, theme);
    if (chart.isBare && ! chart.surface.empty())
        return;
    if (chart.isBare)
    {
        g.setColour (theme.axis);
        g.drawRect (frame.plot, 1);
        return;
    }
    drawAxes (g, frame, theme);
    drawColourBar (g, frame.plot.withX (frame.plot.getRight()).withWidth (barWidth), values, map, theme);
}

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
