#include "FocusCommands.h"

#include "EditorLook.h"

#include <antinode_reports/Lettering.h>

namespace antinode
{
FocusCommands::NameButton::NameButton (const juce::String& captionToShow)
    : Button (captionToShow), caption (captionToShow)
{
}

void FocusCommands::NameButton::setLoaded (const juce::String& name)
{
    if (name == loaded)
        return;

    loaded = name;
    setTitle (caption + ": " + name);
    setTooltip (caption + ": " + name + "\nClick to load, save or delete presets.");
    repaint();
}

void FocusCommands::NameButton::paintButton (juce::Graphics& g, bool isOver, bool isDown)
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

FocusCommands::FocusCommands (TopBar& bar, AntinodeProcessor& processorToShow, History& historyToShow)
    : history (historyToShow),
      armLink (processorToShow.parameters().arm(), [this] (float value) { showArm (value >= 0.5f); })
{
    undo.setButtonText (juce::String::fromUTF8 ("\xE2\x86\xB6"));
    redo.setButtonText (juce::String::fromUTF8 ("\xE2\x86\xB7"));
    undo.setTitle ("Undo");
    redo.setTitle ("Redo");
    undo.setTooltip ("Undo. Keys: Ctrl Z");
    redo.setTooltip ("Redo. Keys: Ctrl Shift Z");
    bar.theme.setTooltip ("Light or dark. Key: T");
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
    fire.onClick = [this] { onFire(); };
    stop.onClick = [this] { onStop(); };

    constexpr int symbolWidth = 34, apart = 16;
    bar.addLeft (device, 240);
    bar.addLeft (focus, 240);
    bar.addRight (stop, 70);
    bar.addRight (fire, 100);
    bar.addRight (arm, 84, apart);
    bar.addRight (bar.theme, symbolWidth);
    bar.addRight (redo, symbolWidth);
    bar.addRight (undo, symbolWidth);
}

void FocusCommands::showArm (bool isArmed)
{
    arm.setToggleState (isArmed, juce::dontSendNotification);
    arm.setButtonText (isArmed ? "Armed" : "Disarmed");
}

void FocusCommands::refresh (const juce::String& deviceName, const juce::String& focusName)
{
    armLink.refresh();
    device.setLoaded (deviceName);
    focus.setLoaded (focusName);
    undo.setEnabled (history.canUndo());
    redo.setEnabled (history.canRedo());
}

void FocusCommands::setPalette (const Palette& palette)
{
    arm.setColour (juce::TextButton::buttonOnColourId, palette.armed);
    arm.setColour (juce::TextButton::textColourOffId, palette.mutedText);
    fire.setColour (juce::TextButton::buttonColourId, palette.fire);
    fire.setColour (juce::TextButton::textColourOffId, palette.onStrong);
    stop.setColour (juce::TextButton::textColourOffId, palette.warning);
}
} // namespace antinode
