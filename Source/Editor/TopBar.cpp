#include "TopBar.h"

#include "EditorLook.h"

#include <antinode_charts/Lettering.h>

namespace antinode
{
namespace
{
constexpr int barMargin = 8, barGap = 6;

void colour (juce::TextButton& button, juce::Colour fill, juce::Colour fillOn, juce::Colour text, juce::Colour textOn)
{
    button.setColour (juce::TextButton::buttonColourId, fill);
    button.setColour (juce::TextButton::buttonOnColourId, fillOn);
    button.setColour (juce::TextButton::textColourOffId, text);
    button.setColour (juce::TextButton::textColourOnId, textOn);
}
} // namespace

TopBar::NameButton::NameButton (const juce::String& captionToShow) : Button (captionToShow), caption (captionToShow) {}

void TopBar::NameButton::setLoaded (const juce::String& name)
{
    if (name == loaded)
        return;

    loaded = name;
    setTitle (caption + ": " + name);
    setTooltip (caption + ": " + name + "\nClick to load, save or delete presets.");
    repaint();
}

void TopBar::NameButton::paintButton (juce::Graphics& g, bool isOver, bool isDown)
{
    const auto& palette = EditorLook::findPalette (*this);
    getLookAndFeel().drawButtonBackground (g, *this, palette.raised, isOver, isDown);
    auto area = getLocalBounds().toFloat().reduced (9, 0);
    juce::Path arrow;
    const auto tip = area.removeFromRight (12).getCentre();
    arrow.addTriangle (tip.translated (-3.5f, -2), tip.translated (4.5f, -2), tip.translated (0.5f, 3));
    g.setColour (palette.mutedText);
    g.fillPath (arrow);
    const auto captionStyle = TextStyle { 10, false, palette.mutedText };
    const auto nameStyle = TextStyle { EditorLook::textHeight, false, palette.text };
    auto rows = area.withSizeKeepingCentre (area.getWidth(), 27);
    drawText (g, caption.toStdString(), rows.removeFromTop (12), juce::Justification::centredLeft, captionStyle);
    drawText (g, loaded.toStdString(), rows, juce::Justification::centredLeft, nameStyle);
}

TopBar::TopBar (AntinodeProcessor& processorToShow, History& historyToShow)
    : history (historyToShow),
      armLink (processorToShow.parameters().arm(), [this] (float value) { showArm (value >= 0.5f); })
{
    setTitle ("Commands");
    undo.setButtonText (juce::String::fromUTF8 ("\xE2\x86\xB6"));
    redo.setButtonText (juce::String::fromUTF8 ("\xE2\x86\xB7"));
    theme.setButtonText (juce::String::fromUTF8 ("\xE2\x97\x90"));
    undo.setTitle ("Undo");
    redo.setTitle ("Redo");
    theme.setTitle ("Light or dark");
    undo.setTooltip ("Undo. Keys: Ctrl Z");
    redo.setTooltip ("Redo. Keys: Ctrl Shift Z");
    theme.setTooltip ("Light or dark. Key: T");
    arm.setTooltip ("If armed, triggers put voltage on the ceramics; if disarmed, all ceramics stay at 0 V. Key: A");
    fire.setTooltip ("Fires the focus at its own position. Keys: Space, Return on the surface");
    stop.setTooltip ("Fades out all playing foci. Key: Escape");
    arm.setTitle ("Arm");
    fire.setTitle ("Fire");
    stop.setTitle ("Stop");
    arm.setClickingTogglesState (true);
    armLink.refresh();
    arm.onClick = [this]
    {
        armLink.setAsGesture (arm.getToggleState() ? 1.0f : 0.0f);
        armLink.refresh();
    };
    device.onClick = [this] { onBrowse (LibraryKind::device); };
    focus.onClick = [this] { onBrowse (LibraryKind::focus); };
    undo.onClick = [this] { onUndo(); };
    redo.onClick = [this] { onRedo(); };
    theme.onClick = [this] { onTheme(); };
    fire.onClick = [this] { onFire(); };
    stop.onClick = [this] { onStop(); };

    for (juce::Button* const button :
         { static_cast<juce::Button*> (&device), static_cast<juce::Button*> (&focus),
           static_cast<juce::Button*> (&undo), static_cast<juce::Button*> (&redo), static_cast<juce::Button*> (&theme),
           static_cast<juce::Button*> (&arm), static_cast<juce::Button*> (&fire), static_cast<juce::Button*> (&stop) })
        addAndMakeVisible (button);
}

void TopBar::showArm (bool isArmed)
{
    arm.setToggleState (isArmed, juce::dontSendNotification);
    arm.setButtonText (isArmed ? "Armed" : "Disarmed");
}

void TopBar::refresh (const juce::String& deviceName, const juce::String& focusName)
{
    armLink.refresh();
    device.setLoaded (deviceName);
    focus.setLoaded (focusName);
    undo.setEnabled (history.canUndo());
    redo.setEnabled (history.canRedo());
}

void TopBar::lookAndFeelChanged()
{
    const auto& palette = EditorLook::findPalette (*this);

    for (auto* const button : { &undo, &redo, &theme })
        colour (*button, palette.raised, palette.raised, palette.text, palette.text);

    colour (arm, palette.raised, palette.armed, palette.mutedText, palette.onStrong);
    colour (fire, palette.fire, palette.fire, palette.onStrong, palette.onStrong);
    colour (stop, palette.raised, palette.raised, palette.warning, palette.warning);
}

void TopBar::paint (juce::Graphics& g)
{
    g.fillAll (EditorLook::findPalette (*this).panel);
}

void TopBar::resized()
{
    auto area = getLocalBounds().reduced (barMargin, 6);
    stop.setBounds (area.removeFromRight (70));
    area.removeFromRight (barGap);
    fire.setBounds (area.removeFromRight (100));
    area.removeFromRight (barGap);
    arm.setBounds (area.removeFromRight (84));
    area.removeFromRight (2 * barMargin);

    for (auto* const button : { &theme, &redo, &undo })
    {
        button->setBounds (area.removeFromRight (34));
        area.removeFromRight (barGap);
    }

    const auto each = std::min (240, (area.getWidth() - barGap) / 2);
    device.setBounds (area.removeFromLeft (each));
    area.removeFromLeft (barGap);
    focus.setBounds (area.removeFromLeft (each));
}
} // namespace antinode
