#include "SurfaceView.h"

#include "EditorLook.h"
#include "JuceText.h"

#include <Processor/ParameterSet.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/Lettering.h>
#include <antinode_session/FocusSettings.h>

#include <algorithm>

namespace antinode
{
SurfaceView::SurfaceView (const juce::String& description, const juce::String& tooltip, bool hasColourBar)
{
    painter.setColourBar (hasColourBar);
    setTitle ("Surface");
    setDescription (description);
    setTooltip (tooltip);
}

void SurfaceView::setPicture (std::shared_ptr<const SurfacePicture> newPicture)
{
    picture = std::move (newPicture);
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
