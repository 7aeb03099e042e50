#include "SurfaceView.h"

#include "EditorLook.h"

#include <Processor/ParameterSet.h>
#include <antinode_base/Prefixes.h>
#include <antinode_charts/Lettering.h>
#include <antinode_session/FocusSettings.h>

#include <cmath>

namespace antinode
{
SurfaceView::SurfaceView (AntinodeProcessor& processorToShow, History& history)
    : processor (processorToShow), touching (processorToShow, history)
{
    const auto& parameters = processor.parameters();
    spotX = parameters.find ("x");
    spotY = parameters.find ("y");
    probeX = parameters.find ("probe_x");
    probeY = parameters.find ("probe_y");
    width = parameters.find ("width");
    height = parameters.find ("peak_velocity");
    setTitle ("Surface");
    setDescription (
        "Velocity of the surface at the focus. Arrow keys move the spot, Alt with arrow keys the probe, Shift makes "
        "the steps smaller. N rests a finger at the probe, Delete lifts the one nearest to it. Space fires.");
    setTooltip ("Drag the spot (ring), the probe (diamond) or a finger (disc); a right click rests and lifts "
                "fingers.\nArrow keys move the spot by 1 % of the surface, with Shift by "
                "0.1 %; Alt with arrow keys moves the probe. Space fires.");
    setWantsKeyboardFocus (true);
}

void SurfaceView::setPicture (std::shared_ptr<const DesignPicture> newPicture)
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

void SurfaceView::refresh()
{
    const std::array values { parameterValue (*spotX),  parameterValue (*spotY), parameterValue (*probeX),
                              parameterValue (*probeY), parameterValue (*width), parameterValue (*height) };

    if (touching.refresh() || values != shownValues)
    {
        shownValues = values;
        repaint();
    }
}

void SurfaceView::lookAndFeelChanged()
{
    painter.setPalette (EditorLook::findPalette (*this));
    repaint();
}

juce::Point<float> SurfaceView::pixelPlace (const juce::RangedAudioParameter& x, const juce::RangedAudioParameter& y,
                                            double lineHeight) const
{
    if (picture == nullptr)
        return {};

    const auto& surface = picture->question.model->surface;
    const auto [placeX, placeY] = placeFromPercent (surface, parameterValue (x), parameterValue (y));
    return painter.frame().at (placeX * milli, painter.isLine() ? lineHeight : placeY * milli);
}

double SurfaceView::shownSpotHeight() const
{
    return parameterValue (*height);
}

std::unique_ptr<juce::AccessibilityHandler> SurfaceView::createAccessibilityHandler()
{
    return std::make_unique<juce::AccessibilityHandler> (
        *this, juce::AccessibilityRole::image,
        juce::AccessibilityActions().addAction (juce::AccessibilityActionType::press,
                                                [this]
                                                {
                                                    if (onFire)
                                                        onFire();
                                                }));
}

void SurfaceView::paint (juce::Graphics& g)
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
    touching.paint (g, painter.frame(), palette);
    paintProbe (g);
    paintSpot (g);
    paintMessage (g);

    if (hasKeyboardFocus (false))
    {
        g.setColour (palette.accent);
        g.drawRect (getLocalBounds(), 1);
    }
}

void SurfaceView::paintSpot (juce::Graphics& g) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto& plot = painter.frame();
    const auto centre = spot();
    const auto halfWidth = std::abs (plot.xAt (0.5 * parameterValue (*width)) - plot.xAt (0));
    g.saveState();
    g.reduceClipRegion (plot.plot.expanded (10).getSmallestIntegerContainer());
    g.setColour (palette.fire.withAlpha (0.8f));

    if (painter.isLine())
    {
        const auto half = plot.yAt (0.5 * shownSpotHeight());
        g.fillRect (juce::Rectangle<float> (2 * halfWidth, 1.5f).withCentre ({ centre.x, half }));
        g.fillRect (juce::Rectangle<float> (centre.x - 0.5f, centre.y, 1, plot.yAt (0) - centre.y));
    }
    else
    {
        juce::Path ring, dashes;
        ring.addEllipse (juce::Rectangle<float> (2 * halfWidth, 2 * halfWidth).withCentre (centre));
        constexpr float pattern[] = { 5, 4 };
        juce::PathStrokeType (1.3f).createDashedStroke (dashes, ring, pattern, 2);
        g.fillPath (dashes);
    }

    g.setColour (palette.window.withAlpha (0.85f));
    g.drawEllipse (juce::Rectangle<float> (15, 15).withCentre (centre), 4.5f);
    g.setColour (palette.fire);
    g.drawEllipse (juce::Rectangle<float> (15, 15).withCentre (centre), 2.5f);
    g.fillEllipse (juce::Rectangle<float> (4, 4).withCentre (centre));
    g.restoreState();
}

void SurfaceView::paintProbe (juce::Graphics& g) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto centre = probe();
    juce::Path diamond;
    diamond.addQuadrilateral (centre.x - 7, centre.y, centre.x, centre.y - 7, centre.x + 7, centre.y, centre.x,
                              centre.y + 7);
    g.setColour (palette.window.withAlpha (0.85f));
    g.strokePath (diamond, juce::PathStrokeType (4));
    g.setColour (palette.armed);
    g.strokePath (diamond, juce::PathStrokeType (2));
}

void SurfaceView::paintMessage (juce::Graphics& g) const
{
    if (picture->error.empty())
        return;

    const auto& palette = EditorLook::findPalette (*this);
    juce::AttributedString words;
    words.append (juce::String::fromUTF8 (picture->error.c_str()), EditorLook::font(), palette.text);
    juce::TextLayout layout;
    layout.createLayout (words, std::min (420.0f, static_cast<float> (getWidth()) - 60));
    const auto box = juce::Rectangle<float> (layout.getWidth() + 24, layout.getHeight() + 18)
                         .withCentre (painter.frame().plot.getCentre());
    g.setColour (palette.panel.withAlpha (0.94f));
    g.fillRoundedRectangle (box, 6);
    g.setColour (palette.warning);
    g.drawRoundedRectangle (box, 6, 1.2f);
    layout.draw (g, box.reduced (12, 9));
}
} // namespace antinode
