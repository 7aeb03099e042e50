#include "SurfaceView.h"

#include "EditorLook.h"

#include <Processor/ParameterSet.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/AnnotationDrawing.h>
#include <antinode_reports/CurveDrawing.h>
#include <antinode_reports/Drawing.h>
#include <antinode_reports/Lettering.h>
#include <antinode_reports/MapDrawing.h>
#include <antinode_reports/MapOverlays.h>
#include <antinode_reports/PlotFrame.h>
#include <antinode_session/FocusSettings.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t wanted = 0, reached = 1, truncated = 2;

AxisRange symmetrical (double maximum)
{
    const auto usable = maximum > 0 ? 1.08 * maximum : 1.0;
    return { -usable, usable };
}

CurvePiece curvePoints (const PlotFrame& frame, const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    CurvePiece points;
    points.reserve (static_cast<std::size_t> (x.size()));

    for (Eigen::Index i = 0; i < x.size(); ++i)
        points.push_back (frame.at (x[i], y[i]));

    return points;
}

/** The ceramics' numbers, as at their meters: names are too long for small ones. */
void drawNumbers (juce::Graphics& g, const PlotFrame& frame, const std::vector<MapRectangle>& ceramics,
                  const Theme& theme)
{
    constexpr auto usual = 10.0f, smallest = 6.0f;
    TextStyle style { usual, false, theme.text };
    const auto areaOf = [&frame] (const MapRectangle& ceramic)
    {
        return juce::Rectangle<float> (frame.at (ceramic.xMinimum, ceramic.yMaximum),
                                       frame.at (ceramic.xMaximum, ceramic.yMinimum));
    };

    // All in one size, so that 10 is there where 9 is.
    for (std::size_t i = 0; i < ceramics.size(); ++i)
        if (const auto fitting = usual * areaOf (ceramics[i]).getWidth()
                                 / (textWidth (std::to_string (i + 1), { usual, false, {} }) + 1);
            fitting >= smallest)
            style.height = std::min (style.height, fitting);

    for (std::size_t i = 0; i < ceramics.size(); ++i)
        if (const auto number = std::to_string (i + 1); textWidth (number, style) < areaOf (ceramics[i]).getWidth())
            drawText (g, number, areaOf (ceramics[i]), juce::Justification::centred, style);
}
} // namespace

void SurfacePainter::setPicture (std::shared_ptr<const SurfacePicture> newPicture)
{
    picture = std::move (newPicture);
    below = above = aboveFocus = {};
}

void SurfacePainter::setPalette (const Palette& palette)
{
    colours = &palette;
    below = above = aboveFocus = {};
}

bool SurfacePainter::isLine() const
{
    return picture == nullptr || picture->model->surface.kind == SurfaceKind::line;
}

juce::Image SurfacePainter::emptyLayer() const
{
    const auto pixels = [this] (int length)
    { return std::max (1, juce::roundToInt (static_cast<float> (length) * scale)); };
    return { juce::Image::ARGB, pixels (area.getWidth()), pixels (area.getHeight()), true, juce::SoftwareImageType() };
}

void SurfacePainter::layOut (juce::Rectangle<int> newArea, float newScale)
{
    if (picture == nullptr || (below.isValid() && newArea == area && newScale == scale))
        return;

    area = newArea;
    scale = newScale;
    below = emptyLayer();
    above = aboveFocus = still = {};
    juce::Graphics g (below);
    g.addTransform (juce::AffineTransform::scale (scale));

    if (isLine())
        layOutLine (std::get<LineChart> (*picture->field), g);
    else
        layOutPlate (std::get<HeatMap> (*picture->field), g);

    for (auto* const layer : { &above, &aboveFocus })
        if (! isLine())
        {
            *layer = emptyLayer();
            juce::Graphics upper (*layer);
            upper.addTransform (juce::AffineTransform::scale (scale));
            paintOverlay (upper, layer == &aboveFocus);
        }

    if (picture->frames->available() > 1)
        return;

    auto whole = emptyLayer();
    juce::Graphics inner (whole);
    inner.addTransform (juce::AffineTransform::scale (scale));
    paint (inner, 0);
    still = whole;
}

void SurfacePainter::layOutLine (const LineChart& chart, juce::Graphics& g)
{
    const auto& theme = colours->charts;
    g.fillAll (colours->panel);
    auto rest = area.toFloat().reduced (theme.padding);
    rest = drawLegend (g, rest, legendEntries (chart, theme), LegendPlace::top, theme);
    const auto data = yDataRange (chart).value_or (AxisRange {});
    const auto maximum = std::max (std::abs (data.minimum), std::abs (data.maximum));
    const auto x = xDataRange (chart).value_or (AxisRange {});
    plot = layOutPlot (rest, { chart.xLabel, usableRange (x), false, {}, true },
                       { chart.yLabel, symmetrical (maximum), false, {}, true },
                       { heightAbove ({}, chart.spans, theme), 8 }, theme);
    drawGrid (g, plot, theme);
    drawSpans (g, plot, chart.spans, theme);
    drawAxes (g, plot, theme);
    g.reduceClipRegion (plot.plot.getSmallestIntegerContainer());

    for (const auto i : { wanted, truncated })
    {
        const auto& series = chart.series[i];
        drawCurve (g, curvePoints (plot, series.x, series.y),
                   { seriesColour (theme, series.colour, i), theme.lineWidth, series.style });
    }
}

void SurfacePainter::layOutPlate (const HeatMap& chart, juce::Graphics& g)
{
    const auto& theme = colours->charts;
    g.fillAll (colours->panel);
    const auto rest = area.toFloat().reduced (theme.padding);
    const auto maximum = picture->frames->largest * milli;
    const ChartAxis values { chart.valueLabel, usableRange ({ -maximum, maximum }), false, {}, false };
    const auto barWidth = hasColourBar ? colourBarWidth (values, rest.getHeight(), theme) : 0.0F;
    plot = withEqualAspect (layOutPlot (rest, { chart.xLabel, chart.x, false, {}, false },
                                        { chart.yLabel, chart.y, false, {}, false }, { 0, barWidth }, theme));
    drawAxes (g, plot, theme);

    if (hasColourBar)
        drawColourBar (g, plot.plot.withX (plot.plot.getRight()).withWidth (barWidth), values, theme.diverging, theme);
}

void SurfacePainter::paintOverlay (juce::Graphics& g, bool withContours) const
{
    const auto& chart = std::get<HeatMap> (*picture->field);
    g.reduceClipRegion (plot.plot.getSmallestIntegerContainer());

    if (withContours)
    {
        const juce::Graphics::ScopedSaveState state (g);

        if (! chart.surface.empty())
            g.reduceClipRegion (pathOf (chart.surface, plot));

        drawContours (g, plot, chart, colours->charts);
    }

    drawSurface (g, plot, chart.surface, colours->charts);

    auto rectangles = chart.rectangles;

    for (auto& rectangle : rectangles)
        rectangle.label.clear();

    drawPlaces (g, plot, rectangles, chart.points, colours->charts);
    drawNumbers (g, plot, rectangles, colours->charts);
}

void SurfacePainter::paint (juce::Graphics& g, int frame) const
{
    g.setOpacity (1);

    if (still.isValid())
        return drawLayer (g, still);

    const auto shown = picture->frames->available() > 1 ? frame : 0;
    const auto isFocus = picture->frames->available() == 1 || frame == FieldFrames::atFocus;
    {
        const juce::Graphics::ScopedSaveState state (g);

        // A map covers all of the plot, unless it has an outline: large images cost more than small ones.
        if (! isLine() && std::get<HeatMap> (*picture->field).surface.empty())
            g.excludeClipRegion (plot.plot.toNearestInt());

        drawLayer (g, below);
    }
    {
        const juce::Graphics::ScopedSaveState state (g);
        if (isLine())
            paintLine (g, shown);
        else
            paintPlate (g, shown);
    }

    if (isLine())
        return;

    g.setOpacity (1);
    drawLayer (g, isFocus ? aboveFocus : above);
}

/** Pixel by pixel, at the nearest one: anything between would be ten times as slow. */
void SurfacePainter::drawLayer (juce::Graphics& g, const juce::Image& layer) const
{
    g.setImageResamplingQuality (juce::Graphics::lowResamplingQuality);
    g.drawImageTransformed (layer, juce::AffineTransform::scale (1 / scale));
}

void SurfacePainter::paintLine (juce::Graphics& g, int frame) const
{
    const auto& series = std::get<LineChart> (*picture->field).series[reached];
    const auto colour = seriesColour (colours->charts, series.colour, reached);
    const auto points = curvePoints (plot, series.x, picture->frames->lines.col (frame) * milli);
    g.reduceClipRegion (plot.plot.getSmallestIntegerContainer());
    fillBelowCurve (g, points, plot.yAt (0), colour.withAlpha (0.14f));
    drawCurve (g, points, { colour, 2, LineStyle::solid });
}

void SurfacePainter::paintPlate (juce::Graphics& g, int frame) const
{
    const auto maximum = std::max (picture->frames->largest, 1e-12);
    const auto image = colourImage (picture->frames->maps[static_cast<std::size_t> (frame)], { -maximum, maximum },
                                    colours->charts.diverging);
    g.setImageResamplingQuality (juce::Graphics::mediumResamplingQuality);

    if (const auto& surface = std::get<HeatMap> (*picture->field).surface; ! surface.empty())
        g.reduceClipRegion (pathOf (surface, plot));

    g.drawImage (image, plot.plot);
}

SurfaceView::SurfaceView (const juce::String& description, const juce::String& tooltip, bool hasColourBar)
{
    painter.setColourBar (hasColourBar);
    setTitle ("Surface");
    setDescription (description);
    setTooltip (tooltip);
}

void SurfaceView::setPicture (std::shared_ptr<const SurfacePicture> newPicture)
{
    if (std::exchange (picture, std::move (newPicture)) != picture)
        painter.setPicture (picture);

    repaint();
}

void SurfaceView::setFrame (int newFrame)
{
    if (std::exchange (frame, newFrame) != newFrame)
        repaint();
}

void SurfaceView::lookAndFeelChanged()
{
    painter.setPalette (EditorLook::findPalette (*this));
    repaint();
}

void SurfaceView::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);

    if (! isShown())
    {
        drawText (g, "Solving the device \xE2\x80\xA6", getLocalBounds().toFloat(), juce::Justification::centred,
                  { 14, false, palette.mutedText });
        return;
    }

    painter.layOut (getLocalBounds(), g.getInternalContext().getPhysicalPixelScaleFactor());
    painter.paint (g, frame);
    paintOnTop (g);
    paintError (g);

    if (hasKeyboardFocus (false))
    {
        g.setColour (palette.accent);
        g.drawRect (getLocalBounds(), 1);
    }
}

void SurfaceView::paintError (juce::Graphics& g) const
{
    if (picture->error.empty())
        return;

    const auto& palette = EditorLook::findPalette (*this);
    juce::AttributedString words;
    words.append (fromUtf8 (picture->error), EditorLook::font(), palette.text);
    juce::TextLayout layout;
    layout.createLayout (words, std::min (420.0f, static_cast<float> (getWidth()) - 60));
    const auto box =
        juce::Rectangle<float> (layout.getWidth() + 24, layout.getHeight() + 18).withCentre (plot().plot.getCentre());
    g.setColour (palette.panel.withAlpha (0.94f));
    g.fillRoundedRectangle (box, 6);
    g.setColour (palette.warning);
    g.drawRoundedRectangle (box, 6, 1.2f);
    layout.draw (g, box.reduced (12, 9));
}

juce::Point<float> SurfaceView::pixels (double xPercent, double yPercent, double height) const
{
    if (! isShown())
        return {};

    const auto [x, y] = placeFromPercent (surface(), xPercent, yPercent);
    return plot().at (x * milli, isLine() ? height : y * milli);
}

juce::Point<float> SurfaceView::pixels (const Place& place, double height) const
{
    return pixels (parameterValue (*place.x), parameterValue (*place.y), height);
}

std::pair<double, double> SurfaceView::percentAt (juce::Point<float> at) const
{
    const auto area = plot().plot.toDouble();
    return { 100 * (static_cast<double> (at.x) - area.getX()) / area.getWidth(),
             100 * (area.getBottom() - static_cast<double> (at.y)) / area.getHeight() };
}

void SurfaceView::move (const Place& place, double xPercent, double yPercent)
{
    setValue (*place.x, xPercent);

    if (! isLine())
        setValue (*place.y, yPercent);

    repaint();
}

void SurfaceView::grab (const Place& place, juce::Point<float> offset)
{
    held = place;
    heldFrom = offset;
    held.x->beginChangeGesture();
    held.y->beginChangeGesture();
}

void SurfaceView::mouseDrag (const juce::MouseEvent& event)
{
    if (held.x == nullptr)
        return;

    const auto [x, y] = percentAt (event.position - heldFrom);
    move (held, x, y);
}

void SurfaceView::release()
{
    if (held.x == nullptr)
        return;

    held.x->endChangeGesture();
    held.y->endChangeGesture();
    held = {};
}
} // namespace antinode
