#include "FingerViews.h"

#include <Editor/EditorLook.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int controlHeight = 21, controlGap = 4, fingerHeading = 26, fingerMargin = 10;
} // namespace

FingerPanel::FingerPanel (TouchParameters& parameters)
{
    setTitle ("Fingers and output");
    setFocusContainerType (FocusContainerType::focusContainer);

    for (std::size_t k = 0; k < buttons.size(); ++k)
    {
        buttons[k].setButtonText (juce::String (k + 1));
        buttons[k].setTitle ("Finger " + juce::String (k + 1));
        buttons[k].setTooltip ("Shows the controls of finger " + juce::String (k + 1));
        buttons[k].onClick = [this, k] { select (k); };
        addAndMakeVisible (buttons[k]);
        const auto& finger = parameters.finger (k);

        for (juce::RangedAudioParameter* const parameter : std::initializer_list<juce::RangedAudioParameter*> {
                 finger.presence, finger.x, finger.y, finger.level, finger.load })
        {
            fingers.push_back (std::make_unique<ParameterControl> (*parameter));
            addChildComponent (*fingers.back());
        }
    }

    for (juce::RangedAudioParameter* const parameter : std::initializer_list<juce::RangedAudioParameter*> {
             &parameters.latency(), &parameters.gain(), &parameters.arm(), &parameters.bypass() })
    {
        output.push_back (std::make_unique<ParameterControl> (*parameter));
        addAndMakeVisible (*output.back());
    }

    select (0);
}

void FingerPanel::select (std::size_t finger)
{
    shown = finger;

    for (std::size_t i = 0; i < fingers.size(); ++i)
        fingers[i]->setVisible (i / perFinger == shown);

    lookAndFeelChanged();
}

void FingerPanel::lookAndFeelChanged()
{
    const auto& palette = EditorLook::findPalette (*this);

    for (std::size_t k = 0; k < buttons.size(); ++k)
    {
        buttons[k].setColour (juce::TextButton::buttonColourId, k == shown ? palette.accent : palette.raised);
        buttons[k].setColour (juce::TextButton::textColourOffId, k == shown ? palette.onStrong : palette.text);
    }

    repaint();
}

void FingerPanel::refresh()
{
    for (std::size_t i = 0; i < perFinger; ++i)
        fingers[shown * perFinger + i]->refresh();

    for (const auto& control : output)
        control->refresh();
}

void FingerPanel::refreshTexts (bool isLine)
{
    for (const auto& control : fingers)
    {
        control->refreshText();
        control->setEnabled (! (isLine && control->isAlongY()));
    }
}

int FingerPanel::height()
{
    return 2 * fingerHeading + static_cast<int> (perFinger + ofOutput) * (controlHeight + controlGap) + controlGap;
}

void FingerPanel::resized()
{
    auto area = getLocalBounds().reduced (fingerMargin, 0);
    auto heading = area.removeFromTop (fingerHeading).withTrimmedLeft (60).reduced (0, 3);
    const auto width = heading.getWidth() / mostFingers;

    for (auto& button : buttons)
        button.setBounds (heading.removeFromLeft (width).reduced (1, 0));

    const auto row = [&]
    {
        const auto bounds = area.removeFromTop (controlHeight);
        area.removeFromTop (controlGap);
        return bounds;
    };

    for (std::size_t i = 0; i < perFinger; ++i)
    {
        const auto bounds = row(); // Of all fingers: one is visible.

        for (auto each = i; each < fingers.size(); each += perFinger)
            fingers[each]->setBounds (bounds);
    }

    area.removeFromTop (fingerHeading);

    for (const auto& control : output)
        control->setBounds (row());
}

void FingerPanel::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    g.setColour (palette.mutedText);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight, true));
    auto area = getLocalBounds().reduced (fingerMargin, 0);
    g.drawText ("Finger", area.removeFromTop (fingerHeading), juce::Justification::centredLeft);
    area.removeFromTop (static_cast<int> (perFinger) * (controlHeight + controlGap));
    g.drawText ("Output", area.removeFromTop (fingerHeading), juce::Justification::centredLeft);
}

namespace
{
constexpr float smallestDisc = 11; // pixels: what can be hit
constexpr float motionGap = 6, motionWidth = 104, motionHeight = 24, motionText = 13;

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

TouchSurface::TouchSurface (TouchProcessor& processorToShow)
    : SurfaceView (
        "Where the fingers are.",
        "Drag the numbered fingers. Filled: plays its input. Ring: silent.\nDouble click: the next finger is "
        "put down. Right click: state and kind of a finger.",
        false),
      processor (processorToShow)
{
}

SurfaceView::Place TouchSurface::placeOf (std::size_t finger) const
{
    const auto& parameters = processor.parameters().finger (finger);
    return { parameters.x, parameters.y };
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

void TouchSurface::show (std::array<AskedMotion, mostFingers> motions)
{
    const auto isSeen = [] (const auto& each) { return ! each.waveform.empty(); };
    const auto changes =
        std::any_of (motions.begin(), motions.end(), isSeen) || std::any_of (asked.begin(), asked.end(), isSeen);
    asked = std::move (motions);

    if (changes)
        repaint();
}

float TouchSurface::radiusOf (const FingerSettings& finger) const
{
    if (finger.load == FingerLoad::none)
        return smallestDisc;

    const auto& kind = fingerKinds[static_cast<std::size_t> (finger.load) - 1];
    return std::max (smallestDisc, plot().xAt (kind.radius * milli) - plot().xAt (0));
}

std::optional<std::size_t> TouchSurface::fingerAt (juce::Point<float> place) const
{
    const auto now = processor.parameters().settings();

    for (std::size_t k = 0; isShown() && k < now.fingers.size(); ++k)
        if (const auto& each = now.fingers[k];
            each.presence != FingerPresence::absent && place.getDistanceFrom (at (each)) <= radiusOf (each))
            return k;

    return {};
}

void TouchSurface::paintOnTop (juce::Graphics& g)
{
    for (std::size_t k = 0; k < asked.size(); ++k)
        if (! asked[k].waveform.empty() && shown.fingers[k].presence != FingerPresence::absent)
            paintMotion (g, k);

    // The first ones last: where fingers lie on each other they are in front.
    for (auto k = shown.fingers.size(); k-- > 0;)
        if (shown.fingers[k].presence != FingerPresence::absent)
            paintFinger (g, k);
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

        return plot().plot.contains (place);
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

std::optional<std::size_t> TouchSurface::putDown (juce::Point<float> place)
{
    const auto now = processor.parameters().settings();

    for (std::size_t k = 0; isShown() && k < now.fingers.size(); ++k)
        if (now.fingers[k].presence == FingerPresence::absent)
        {
            const auto [x, y] = percentAt (place);
            move (placeOf (k), x, y);
            const auto presence =
                static_cast<int> (k) < processor.inputs() ? FingerPresence::plays : FingerPresence::silent;
            choose (*processor.parameters().finger (k).presence, static_cast<int> (presence));
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
    const auto finger = fingerAt (event.position);

    if (! finger)
        return;

    if (onSelect)
        onSelect (*finger);

    if (event.mods.isPopupMenu())
        showMenu (*finger);
    else
        grab (placeOf (*finger), event.position - this->finger (*finger));
}

void TouchSurface::mouseDoubleClick (const juce::MouseEvent& event)
{
    if (fingerAt (event.position))
        return;

    if (const auto finger = putDown (event.position); finger && onSelect)
        onSelect (*finger);
}
} // namespace antinode
