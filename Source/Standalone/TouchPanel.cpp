#include "TouchPanel.h"

#include "PanelSizes.h"
#include "RestingTouches.h"

#include <Editor/EditorLook.h>

#include <string_view>

namespace antinode
{
namespace
{
constexpr int nameWidth = 90, fieldWidth = 80, choiceWidth = 190, countMilliseconds = 250;
constexpr auto thisComputer = "127.0.0.1", wholeNetwork = "0.0.0.0";

/** What a choice of cursorWords does. */
juce::String cursorText (const AudioHost& host, std::string_view word, std::string_view finger)
{
    if (! finger.empty())
        return (host.playsFoci() ? "rest as " : "play as ") + juce::String (std::string (word)) + " fingers";

    return host.playsFoci() ? "play foci" : "play fingers as they are";
}
} // namespace

TouchPanel::TouchPanel (AudioHost& hostToUse) : host (hostToUse)
{
    const auto& ports = host.settings().touch;
    oscPort.setText (juce::String (ports.oscPort), false);
    tuioPort.setText (juce::String (ports.tuioPort), false);
    network.setToggleState (ports.address != thisComputer, juce::dontSendNotification);
    status.setJustificationType (juce::Justification::topLeft);

    for (auto* const label : { &oscName, &tuioName, &cursorsName, &status })
        label->setFont (EditorLook::font (EditorLook::smallTextHeight));

    for (auto* const editor : { &oscPort, &tuioPort })
    {
        editor->setInputRestrictions (5, "0123456789");
        editor->setFont (EditorLook::font (EditorLook::smallTextHeight));
        editor->setJustification (juce::Justification::centredLeft);
        editor->setTooltip ("UDP port; 0: off");
        editor->setEscapeAndReturnKeysConsumed (false);
        editor->onReturnKey = [this] { apply(); };
    }

    for (std::size_t i = 0; i < cursorWords.size(); ++i)
    {
        const auto [word, finger] = cursorWords[i];
        cursors.addItem (cursorText (host, word, finger), static_cast<int> (i) + 1);

        if (finger == ports.finger)
            cursors.setSelectedId (static_cast<int> (i) + 1, juce::dontSendNotification);
    }

    cursors.setTooltip (host.playsFoci()
                            ? "What TUIO cursors do. Fingers damp the surface; no focus is designed for them"
                            : "What a finger is to the surface that a touch puts down");
    applyButton.onClick = [this] { apply(); };

    for (auto* const child : std::initializer_list<juce::Component*> {
             &oscName, &tuioName, &status, &oscPort, &tuioPort, &cursorsName, &cursors, &network, &applyButton })
        addAndMakeVisible (child);

    showState();
    startTimer (countMilliseconds);
}

void TouchPanel::apply()
{
    const auto finger = cursorWords[static_cast<std::size_t> (cursors.getSelectedId() - 1)].second;
    const TouchPorts wanted { oscPort.getText().getIntValue(), tuioPort.getText().getIntValue(),
                              network.getToggleState() ? wholeNetwork : thisComputer, std::string (finger) };
    host.attempt (MessageSource::ports, [&] { host.setTouch (wanted); });
    showState();
}

void TouchPanel::showState()
{
    const auto failure = host.message (MessageSource::ports);
    status.setText (failure.isNotEmpty() ? failure : host.touchStatus(), juce::dontSendNotification);
}

void TouchPanel::lookAndFeelChanged()
{
    for (auto* const editor : { &oscPort, &tuioPort })
        editor->applyColourToAllText (EditorLook::findPalette (*this).text);
}

void TouchPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);
    const auto place = [&] (juce::Component& name, juce::Component& field, int width)
    {
        auto row = area.removeFromTop (panelRowHeight).reduced (0, 2);
        name.setBounds (row.removeFromLeft (nameWidth));
        field.setBounds (row.removeFromLeft (width));
    };
    place (oscName, oscPort, fieldWidth);
    place (tuioName, tuioPort, fieldWidth);
    place (cursorsName, cursors, choiceWidth);
    network.setBounds (area.removeFromTop (panelRowHeight));
    applyButton.setBounds (area.removeFromTop (panelRowHeight).reduced (0, 2).removeFromLeft (fieldWidth));
    area.removeFromTop (panelMargin);
    status.setBounds (area.removeFromTop (4 * panelRowHeight));
}
} // namespace antinode
