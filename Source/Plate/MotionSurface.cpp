#include "MotionSurface.h"

#include <Editor/EditorLook.h>

#include <antinode_base/Prefixes.h>
#include <antinode_charts/Lettering.h>
#include <antinode_session/FocusSettings.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto grabRadius = 14.0F, radius = 8.0F;

void setPercent (juce::RangedAudioParameter& parameter, float percent)
{
    parameter.setValueNotifyingHost (parameter.convertTo0to1 (std::clamp (percent, 0.0F, 100.0F)));
}
} // namespace

MotionSurface::MotionSurface (PlateProcessor& processorToShow) : processor (processorToShow)
{
    setTitle ("Surface");
    setDescription ("How the surface has moved, two hundred times slower.");
    setTooltip ("How the surface has moved round its largest motion of late, some two hundred times slower.\nDrag the "
                "numbered probes.");
}

void MotionSurface::setPicture (std::shared_ptr<const MotionPicture> newPicture)
{
    picture = std::move (newPicture);
    painter.setPicture (picture->field);
    frame = 0;
    repaint();
}

void MotionSurface::setFrame (int newFrame)
{
    if (std::exchange (frame, newFrame) != newFrame)
        repaint();
}

void MotionSurface::refresh()
{
    const auto now = processor.parameters().settings();

    if (now == shown && shownProbes == processor.shownProbes())
        return;

    shown = now;
    shownProbes = processor.shownProbes();
    repaint();
}

void MotionSurface::lookAndFeelChanged()
{
    painter.setPalette (EditorLook::findPalette (*this));
    repaint();
}

juce::Point<float> MotionSurface::probe (int index) const
{
    if (picture == nullptr)
        return {};

    const auto [xPercent, yPercent] = processor.parameters().settings().probes[static_cast<std::size_t> (index)];
    const auto [x, y] =
        placeFromPercent (picture->model->surface, static_cast<double> (xPercent), static_cast<double> (yPercent));
    return painter.frame().at (x * milli, painter.isLine() ? 0 : y * milli);
}

void MotionSurface::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);

    if (picture == nullptr)
    {
        drawText (g, "Solving the device \xE2\x80\xA6", getLocalBounds().toFloat(), juce::Justification::centred,
                  { 14, false, palette.mutedText });
        return;
    }

    painter.layOut (getLocalBounds(), g.getInternalContext().getPhysicalPixelScaleFactor());
    painter.paint (g, frame);

    // The first ones last: where probes lie on each other they are in front.
    for (auto i = processor.shownProbes(); --i >= 0;)
        paintProbe (g, i);
}

void MotionSurface::paintProbe (juce::Graphics& g, int index) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto circle = juce::Rectangle<float> (2 * radius, 2 * radius).withCentre (probe (index));
    g.setColour (palette.window.withAlpha (0.85F));
    g.fillEllipse (circle);
    g.setColour (palette.armed);
    g.drawEllipse (circle, 1.6F);
    drawText (g, std::to_string (index + 1), circle, juce::Justification::centred, { 10, true, palette.text });
}

int MotionSurface::probeAt (juce::Point<float> place) const
{
    for (int i = 0; picture != nullptr && i < processor.shownProbes(); ++i)
        if (place.getDistanceFrom (probe (i)) < grabRadius)
            return i;

    return none;
}

void MotionSurface::mouseDown (const juce::MouseEvent& event)
{
    dragged = probeAt (event.position);

    if (dragged == none)
        return;

    processor.parameters().probeX (dragged).beginChangeGesture();
    processor.parameters().probeY (dragged).beginChangeGesture();
}

void MotionSurface::mouseDrag (const juce::MouseEvent& event)
{
    if (dragged == none)
        return;

    const auto& plot = painter.frame().plot;
    setPercent (processor.parameters().probeX (dragged), 100 * (event.position.x - plot.getX()) / plot.getWidth());

    if (! painter.isLine())
        setPercent (processor.parameters().probeY (dragged),
                    100 * (plot.getBottom() - event.position.y) / plot.getHeight());

    refresh();
}

void MotionSurface::mouseUp (const juce::MouseEvent&)
{
    if (dragged == none)
        return;

    processor.parameters().probeX (dragged).endChangeGesture();
    processor.parameters().probeY (dragged).endChangeGesture();
    dragged = none;
}
} // namespace antinode
