#include "SettingsPanel.h"

#include "EditorLook.h"

#include <array>
#include <utility>

namespace antinode
{
namespace
{
constexpr int settingsMargin = 12, settingsRow = 28, scaleNameWidth = 170;
constexpr std::array percents { 75, 100, 125, 150, 175, 200, 250, 300 };
constexpr int withTheWindow = 1; // identifiers of a choice cannot be 0
} // namespace

SettingsPanel::SettingsPanel (SeparateNodes nodesToTurn) : nodes (std::move (nodesToTurn))
{
    setTitle ("Settings");
    scaleName.setFont (EditorLook::font (EditorLook::smallTextHeight));
    scale.setTitle ("Size of text and controls");
    scale.setTooltip ("How large all of the window is drawn, as far as all of it stays reachable");
    scale.addItem ("with the window", withTheWindow);

    for (const auto percent : percents)
        scale.addItem (juce::String (percent) + " %", percent);

    setScale (0);
    scale.onChange = [this]
    {
        const auto chosen = scale.getSelectedId();

        if (onScale)
            onScale (chosen == withTheWindow ? 0.0 : chosen / 100.0);
    };
    separate.setTooltip (
        "Leave it off unless custom nodes are inserted: forces, allocation, gains, limiter and plate then run as "
        "separate nodes, with the same samples at a higher cost. Foci are designed again when it is switched.");
    separate.onClick = [this] { nodes.turn (separate.getToggleState()); };
    addAndMakeVisible (scaleName);
    addAndMakeVisible (scale);

    if (nodes.turn)
        addAndMakeVisible (separate);

    refresh();
}

void SettingsPanel::setScale (double wanted)
{
    scale.setSelectedId (wanted > 0 ? juce::roundToInt (100 * wanted) : withTheWindow, juce::dontSendNotification);

    if (scale.getSelectedId() == 0)
        scale.setText (juce::String (juce::roundToInt (100 * wanted)) + " %", juce::dontSendNotification);
}

void SettingsPanel::refresh()
{
    if (nodes.areOn)
        separate.setToggleState (nodes.areOn(), juce::dontSendNotification);
}

void SettingsPanel::resized()
{
    auto area = getLocalBounds().reduced (settingsMargin);
    auto row = area.removeFromTop (settingsRow).reduced (0, 2);
    scaleName.setBounds (row.removeFromLeft (scaleNameWidth));
    scale.setBounds (row.removeFromLeft (140));
    area.removeFromTop (settingsMargin);
    separate.setBounds (area.removeFromTop (settingsRow));
}
} // namespace antinode
