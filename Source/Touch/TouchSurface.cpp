#include "TouchSurface.h"

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
constexpr float smallestDisc = 11; // pixels: what can be hit
constexpr float motionGap = 6, motionWidth = 104, motionHeight = 24, motionText = 13;

float shareOf (float percent)
{
    return std::clamp (percent / 100, 0.0F, 1.0F);
}

void choose (IntegerParameter& parameter, int value)
{
    parameter.beginChangeGesture();
    parameter.setValueNotifyingHost (parameter.convertTo0to1 (static_cast<float> (value)));
    parameter.endChangeGesture();
}

/** A menu of the words of a parameter, the present one ticked. */
void addWords (juce::PopupMenu& menu, IntegerParameter& parameter)
{
    constexpr int longest = 32;
    const auto& asHostsSee = static_cast<const juce::AudioProcessorParameter&> (parameter);

    for (int i = 0; i < parameter.getNumSteps(); ++i)
        menu.addItem (asHostsSee.getText (parameter.convertTo0to1 (static_cast<float> (i)), longest), true,
                      parameter.get() == i, [&parameter, i] { choose (parameter, i); });
}
} // namespace

TouchSurface::TouchSurface (TouchProcessor& processorToShow) : processor (processorToShow)
{
    painter.setColourBar (false);
    setTitle ("Surface");
    setDescription ("Where the fingers are.");
    setTooltip (
        "Drag the numbered fingers. Filled: plays its input. Ring: silent.\nDouble click: the next finger is put "
        "down. Right click: state and kind of a finger.");
}

void TouchSurface::setPicture (std::shared_ptr<const MotionPicture> newPicture)
{
    picture = std::move (newPicture);
    painter.setPicture (picture->field);
    drawn = {};
    repaint();
}

void TouchSurface::refresh (std::shared_ptr<const TouchSnapshot> now, std::size_t selectedNow)
{
    const auto settings = processor.parameters().settings();

    if (now == snapshot && settings == shown && selectedNow == selected)
        return;

    snapshot = std::move (now);
    shown = settings;
    selected = selectedNow;
    repaint();
}

void TouchSurface::lookAndFeelChanged()
{
    painter.setPalette (EditorLook::findPalette (*this));
    drawn = {};
    repaint();
}

void TouchSurface::resized()
{
    drawn = {};
    repaint();
}

void TouchSurface::show (std::array<AskedMotion, mostFingers> motions)
{
    const auto isSeen = [] (const auto& each) { return ! each.waveform.empty(); };
    const auto changes =
        std::any_of (motions.begin(), motions.end(), isSeen) || std::any_of (asked.begin(), asked.end(), isSeen);
    asked = std::move (motions);

    if (changes)
        repaint();
}

juce::Point<float> TouchSurface::at (const FingerSettings& finger) const
{
    const auto [x, y] = placeFromPercent (picture->model->surface, static_cast<double> (finger.xPercent),
                                          static_cast<double> (finger.yPercent));
    return painter.frame().at (x * milli, painter.isLine() ? 0 : y * milli);
}

juce::Point<float> TouchSurface::finger (std::size_t index) const
{
    return picture != nullptr ? at (processor.parameters().settings().fingers[index]) : juce::Point<float>();
}

float TouchSurface::radiusOf (const FingerSettings& finger) const
{
    if (finger.load == FingerLoad::none)
        return smallestDisc;

    const auto& kind = fingerKinds[static_cast<std::size_t> (finger.load) - 1];
    return std::max (smallestDisc, painter.frame().xAt (kind.radius * milli) - painter.frame().xAt (0));
}

std::optional<std::size_t> TouchSurface::fingerAt (juce::Point<float> place) const
{
    const auto now = processor.parameters().settings();

    for (std::size_t k = 0; picture != nullptr && k < now.fingers.size(); ++k)
        if (const auto& each = now.fingers[k];
            each.presence != FingerPresence::absent && place.getDistanceFrom (at (each)) <= radiusOf (each))
            return k;

    return {};
}

void TouchSurface::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);

    if (picture == nullptr)
    {
        drawText (g, "Solving the device \xE2\x80\xA6", getLocalBounds().toFloat(), juce::Justification::centred,
                  { 14, false, palette.mutedText });
        return;
    }

    paintSurface (g);

    for (std::size_t k = 0; k < asked.size(); ++k)
        if (! asked[k].waveform.empty() && shown.fingers[k].presence != FingerPresence::absent)
            paintMotion (g, k);

    // The first ones last: where fingers lie on each other they are in front.
    for (auto k = shown.fingers.size(); k-- > 0;)
        if (shown.fingers[k].presence != FingerPresence::absent)
            paintFinger (g, k);
}

/** Waveforms are drawn 30 times a second, the surface below them once. */
void TouchSurface::paintSurface (juce::Graphics& g)
{
    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();
    const auto width = juce::roundToInt (static_cast<float> (getWidth()) * scale),
               height = juce::roundToInt (static_cast<float> (getHeight()) * scale);

    if (drawn.getWidth() != width || drawn.getHeight() != height)
    {
        drawn = juce::Image (juce::Image::ARGB, std::max (1, width), std::max (1, height), true);
        juce::Graphics inner (drawn);
        inner.addTransform (juce::AffineTransform::scale (scale));
        painter.layOut (getLocalBounds(), scale);
        painter.paint (inner, 0);
    }

    g.drawImage (drawn, getLocalBounds().toFloat());
}

/** Beside a disc: right, left, above or below, the first that is on the surface and covers no other finger. */
juce::Rectangle<float> TouchSurface::areaOfMotion (std::size_t index) const
{
    const auto disc = at (shown.fingers[index]);
    const auto away = radiusOf (shown.fingers[index]) + motionGap;
    const auto middle = juce::Rectangle<float> (motionWidth, motionHeight + motionText).withCentre (disc);
    const auto aside = away + motionWidth / 2, up = away + middle.getHeight() / 2;
    const juce::Rectangle<float> places[] = { middle.translated (aside, 0), middle.translated (-aside, 0),
                                              middle.translated (0, -up), middle.translated (0, up) };
    const auto isFree = [&] (const juce::Rectangle<float>& place)
    {
        for (std::size_t k = 0; k < shown.fingers.size(); ++k)
            if (const auto& other = shown.fingers[k]; k != index && other.presence != FingerPresence::absent
                                                      && place.expanded (radiusOf (other)).contains (at (other)))
                return false;

        return painter.frame().plot.contains (place);
    };
    const auto* const found = std::find_if (std::begin (places), std::end (places), isFree);
    return found != std::end (places) ? *found : places[disc.x > middle.getWidth() + away ? 1 : 0];
}

void TouchSurface::paintMotion (juce::Graphics& g, std::size_t index) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto& motion = asked[index];
    auto area = areaOfMotion (index);
    g.setColour (palette.window.withAlpha (0.75F));
    g.fillRoundedRectangle (area.expanded (3, 1), 3);
    drawText (g, motion.words.toStdString(), area.removeFromBottom (motionText), juce::Justification::centred,
              { 10, false, palette.mutedText });
    juce::Path line;

    for (std::size_t n = 0; n < motion.waveform.size(); ++n)
    {
        const auto share = std::clamp (motion.waveform[n] / static_cast<float> (motion.full), -1.0F, 1.0F);
        const juce::Point<float> point (
            area.getX() + area.getWidth() * static_cast<float> (n) / static_cast<float> (motion.waveform.size() - 1),
            area.getCentreY() - share * area.getHeight() / 2);
        n == 0 ? line.startNewSubPath (point) : line.lineTo (point);
    }

    g.setColour (palette.armed);
    g.strokePath (line, juce::PathStrokeType (1));
}

void TouchSurface::paintFinger (juce::Graphics& g, std::size_t index) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto& finger = shown.fingers[index];
    const auto isPlaying = finger.presence == FingerPresence::plays && static_cast<int> (index) < processor.inputs();
    const auto size = 2 * radiusOf (finger);
    const auto disc = juce::Rectangle<float> (size, size).withCentre (at (finger));

    if (const auto* const played = snapshot != nullptr ? &snapshot->playedFingers.fingers[index] : nullptr;
        played != nullptr && played->presence != FingerPresence::absent)
    {
        g.setColour (palette.mutedText);
        g.drawEllipse (juce::Rectangle<float> (size, size).withCentre (at (*played)), 1);
    }

    g.setColour (isPlaying ? palette.armed : palette.window.withAlpha (0.85F));
    g.fillEllipse (disc);
    g.setColour (index == selected ? palette.text : palette.armed);
    g.drawEllipse (disc.reduced (1), 2);
    drawText (g, std::to_string (index + 1), disc, juce::Justification::centred,
              { 12, true, isPlaying ? palette.onStrong : palette.text });
}

void TouchSurface::moveTo (std::size_t index, juce::Point<float> place)
{
    const auto& plot = painter.frame().plot;
    const auto& parameters = processor.parameters().finger (index);
    parameters.x->setValueNotifyingHost (shareOf (100 * (place.x - plot.getX()) / plot.getWidth()));

    if (! painter.isLine())
        parameters.y->setValueNotifyingHost (shareOf (100 * (plot.getBottom() - place.y) / plot.getHeight()));

    repaint();
}

std::optional<std::size_t> TouchSurface::putDown (juce::Point<float> place)
{
    const auto now = processor.parameters().settings();

    for (std::size_t k = 0; picture != nullptr && k < now.fingers.size(); ++k)
        if (now.fingers[k].presence == FingerPresence::absent)
        {
            const auto& parameters = processor.parameters().finger (k);
            moveTo (k, place);
            const auto presence =
                static_cast<int> (k) < processor.inputs() ? FingerPresence::plays : FingerPresence::silent;
            choose (*parameters.presence, static_cast<int> (presence));
            return k;
        }

    return {};
}

void TouchSurface::showMenu (std::size_t index)
{
    const auto& parameters = processor.parameters().finger (index);
    juce::PopupMenu menu;
    menu.addSectionHeader ("Finger " + juce::String (index + 1));
    addWords (menu, *parameters.presence);
    menu.addSeparator();
    menu.addSectionHeader ("Load");
    addWords (menu, *parameters.load);
    menu.setLookAndFeel (&getLookAndFeel());
    menu.showMenuAsync (juce::PopupMenu::Options().withMousePosition().withDeletionCheck (*this));
}

void TouchSurface::mouseDown (const juce::MouseEvent& event)
{
    dragged = fingerAt (event.position);

    if (! dragged)
        return;

    if (onSelect)
        onSelect (*dragged);

    if (event.mods.isPopupMenu())
    {
        showMenu (*std::exchange (dragged, std::nullopt));
        return;
    }

    processor.parameters().finger (*dragged).x->beginChangeGesture();
    processor.parameters().finger (*dragged).y->beginChangeGesture();
}

void TouchSurface::mouseDrag (const juce::MouseEvent& event)
{
    if (dragged)
        moveTo (*dragged, event.position);
}

void TouchSurface::mouseUp (const juce::MouseEvent&)
{
    if (! dragged)
        return;

    processor.parameters().finger (*dragged).x->endChangeGesture();
    processor.parameters().finger (*dragged).y->endChangeGesture();
    dragged.reset();
}

void TouchSurface::mouseDoubleClick (const juce::MouseEvent& event)
{
    if (fingerAt (event.position))
        return;

    if (const auto finger = putDown (event.position); finger && onSelect)
        onSelect (*finger);
}
} // namespace antinode
