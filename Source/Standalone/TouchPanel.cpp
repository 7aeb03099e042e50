#include "TouchPanel.h"

#include "PanelSizes.h"

#include <Editor/EditorLook.h>
#include <antinode_base/InputError.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int nameWidth = 90, fieldWidth = 80, choiceWidth = 190, countMilliseconds = 250;
constexpr auto thisComputer = "127.0.0.1", wholeNetwork = "0.0.0.0";

juce::String portText (int port)
{
    return port > 0 ? "on port " + juce::String (port) : juce::String ("off");
}

juce::String statusText (StandaloneHost& host)
{
    const auto& touch = host.touch();
    const auto ports = touch.ports();
    const auto counters = touch.counters();
    const auto unplayed = touch.unplayed();
    const auto resting = static_cast<int> (host.processor().touches().size());
    const auto waiting = std::max (0, static_cast<int> (touch.resting().count()) - resting);
    std::int64_t faults = 0;

    for (const auto count : counters.faults)
        faults += count;

    return "OSC " + portText (ports.oscPort) + ", TUIO " + portText (ports.tuioPort) + "\n"
           + juce::String (counters.packets) + " packets, " + juce::String (counters.touches) + " touches forwarded\n"
           + juce::String (resting) + " fingers rest, " + juce::String (waiting) + " wait for room\n"
           + "Dropped: " + juce::String (counters.limited) + " foci above 500 per second, " + juce::String (faults)
           + " faulty,\n" + juce::String (unplayed.outsideSurface) + " outside the surface, "
           + juce::String (unplayed.notAccepted) + " without a device or with a full queue,\n"
           + juce::String (unplayed.withoutKind) + " fingers while cursors play foci";
}
} // namespace

TouchPanel::TouchPanel (StandaloneHost& hostToUse) : host (hostToUse)
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
        const auto text = finger.empty() ? std::string ("play foci") : "rest as " + std::string (word) + " fingers";
        cursors.addItem (juce::String (text), static_cast<int> (i) + 1);

        if (finger == ports.finger)
            cursors.setSelectedId (static_cast<int> (i) + 1, juce::dontSendNotification);
    }

    cursors.setTooltip ("What TUIO cursors do. Fingers damp the surface; no focus is designed for them");
    applyButton.onClick = [this] { apply(); };

    for (auto* const child : std::initializer_list<juce::Component*> {
             &oscName, &tuioName, &status, &oscPort, &tuioPort, &cursorsName, &cursors, &network, &applyButton })
        addAndMakeVisible (child);

    showState();
    startTimer (countMilliseconds);
}

void TouchPanel::apply()
{
    try
    {
        failure.clear();
        const auto [word, finger] = cursorWords[static_cast<std::size_t> (cursors.getSelectedId() - 1)];
        host.setTouch ({ oscPort.getText().getIntValue(), tuioPort.getText().getIntValue(),
                         network.getToggleState() ? wholeNetwork : thisComputer, std::string (finger) });
    }
    catch (const InputError& error)
    {
        failure = juce::String::fromUTF8 (error.what());
    }

    showState();
}

void TouchPanel::showState()
{
    status.setText (failure.isNotEmpty() ? failure : statusText (host), juce::dontSendNotification);
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
