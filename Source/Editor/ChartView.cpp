#include "ChartView.h"

#include "EditorLook.h"

#include <antinode_base/Prefixes.h>
#include <antinode_reports/CurveDrawing.h>
#include <antinode_reports/Drawing.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
ChartView::ChartView (const juce::String& title)
{
    setTitle (title);
    setInterceptsMouseClicks (false, false);
}

void ChartView::setChart (std::shared_ptr<const Chart> newChart, const juce::String& wording)
{
    if (newChart == chart && wording == waiting)
        return;

    waiting = wording;

    chart = std::move (newChart);
    image = {};
    repaint();
}

void ChartView::lookAndFeelChanged()
{
    image = {};
    repaint();
}

void ChartView::drawImage (float scale)
{
    const auto& theme = EditorLook::findPalette (*this).charts;
    image = blankImage (getWidth(), getHeight(), scale, theme.background);
    imageScale = scale;
    juce::Graphics g (image);
    g.addTransform (juce::AffineTransform::scale (scale));
    draw (g, getLocalBounds().toFloat(), *chart, theme);
}

void ChartView::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);

    if (chart == nullptr)
    {
        g.fillAll (palette.panel);
        drawText (g, waiting.toStdString(), getLocalBounds().toFloat(), juce::Justification::centred,
                  { EditorLook::textHeight, false, palette.mutedText });
        return;
    }

    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();

    if (! image.isValid() || scale != imageScale)
        drawImage (scale);

    g.drawImage (image, getLocalBounds().toFloat());
}

namespace
{
constexpr std::size_t shownEntries = 1000; // half a second
constexpr double secondsShown = 0.5, minimumRange = 0.1;

/** 1, 2 or 5 times a power of ten: the axis changes seldom. */
double niceLimit (double value)
{
    const auto power = std::pow (10, std::floor (std::log10 (value)));
    const auto first = value / power;
    return power * (first <= 1 ? 1 : first <= 2 ? 2 : first <= 5 ? 5 : 10);
}
} // namespace

LiveTrace::LiveTrace (const ProbeTrace& traceToShow) : trace (traceToShow)
{
    setTitle ("Live velocity at the probe");
    setInterceptsMouseClicks (false, false);
}

void LiveTrace::refresh()
{
    if (trace.written() == shown)
        return;

    shown = trace.written();
    entries = trace.newest (shownEntries);
    auto maximum = minimumRange;

    for (const auto& entry : entries)
        maximum = std::max ({ maximum, std::abs (static_cast<double> (entry.smallest)) * milli,
                              std::abs (static_cast<double> (entry.largest)) * milli });

    if (const auto wanted = niceLimit (maximum); wanted != range)
    {
        range = wanted;
        axes = {};
    }

    repaint();
}

void LiveTrace::lookAndFeelChanged()
{
    axes = {};
    repaint();
}

void LiveTrace::drawAxesOnce (float scale)
{
    const auto& theme = EditorLook::findPalette (*this).charts;
    axes = blankImage (getWidth(), getHeight(), scale, theme.background);
    juce::Graphics g (axes);
    g.addTransform (juce::AffineTransform::scale (scale));
    const auto rest = drawTitle (g, getLocalBounds().toFloat(), "Live", theme);
    const auto limit = range > 0 ? range : 1;
    plot = layOutPlot (rest, { "time before now (ms)", { -secondsShown * milli, 0 }, false, {}, true },
                       { "velocity (mm/s)", { -limit, limit }, false, {}, true }, { 0, 8 }, theme);
    drawGrid (g, plot, theme);
    drawAxes (g, plot, theme);
}

void LiveTrace::paint (juce::Graphics& g)
{
    if (! axes.isValid())
        drawAxesOnce (g.getInternalContext().getPhysicalPixelScaleFactor());

    g.drawImage (axes, getLocalBounds().toFloat());
    const auto& theme = EditorLook::findPalette (*this).charts;
    const auto count = static_cast<double> (entries.size());
    CurvePiece points;
    points.reserve (2 * entries.size());

    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        const auto time = (static_cast<double> (i) + 1 - count) * secondsShown * milli / shownEntries;
        points.push_back (plot.at (time, static_cast<double> (entries[i].smallest) * milli));
        points.push_back (plot.at (time, static_cast<double> (entries[i].largest) * milli));
    }

    g.reduceClipRegion (plot.plot.getSmallestIntegerContainer());
    drawCurve (g, points, { theme.series[2], theme.lineWidth, LineStyle::solid });
}

ProbePanel::ProbePanel (const ProbeTrace& trace) : chart ("Designed velocity at the probe"), live (trace)
{
    addAndMakeVisible (chart);
    addAndMakeVisible (live);
}

void ProbePanel::resized()
{
    auto area = getLocalBounds();
    chart.setBounds (area.removeFromTop (area.getHeight() / 2));
    live.setBounds (area);
}
} // namespace antinode
