#include "MidiPanel.h"

#include "PanelSizes.h"

#include <Editor/EditorLook.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int panelLookMilliseconds = 1000;
}

MidiPanel::MidiPanel (AudioHost& hostToUse) : host (hostToUse)
{
    all.setToggleState (host.settings().midi.all, juce::dontSendNotification);
    all.onClick = [this] { choose(); };
    none.setFont (EditorLook::font (EditorLook::smallTextHeight));
    addAndMakeVisible (all);
    addChildComponent (none);
    update();
    startTimer (panelLookMilliseconds);
}

void MidiPanel::update()
{
    const auto available = host.midi().available();
    none.setVisible (available.isEmpty());

    if (available != devices)
    {
        devices = available;
        buttons.clear();

        for (const auto& device : devices)
        {
            buttons.push_back (std::make_unique<juce::ToggleButton> (device.name));
            buttons.back()->onClick = [this] { choose(); };
            addAndMakeVisible (*buttons.back());
        }

        resized();
    }

    const auto& chosen = host.settings().midi;

    for (std::size_t i = 0; i < buttons.size(); ++i)
    {
        const auto identifier = devices[static_cast<int> (i)].identifier.toStdString();
        const auto isNamed = std::find (chosen.inputs.begin(), chosen.inputs.end(), identifier) != chosen.inputs.end();
        buttons[i]->setToggleState (chosen.all || isNamed, juce::dontSendNotification);
        buttons[i]->setEnabled (! chosen.all);
    }
}

/** Inputs that are not plugged in at the moment stay selected. */
void MidiPanel::choose()
{
    auto chosen = host.settings().midi;
    chosen.all = all.getToggleState();

    for (std::size_t i = 0; i < buttons.size(); ++i)
    {
        const auto identifier = devices[static_cast<int> (i)].identifier.toStdString();
        std::erase (chosen.inputs, identifier);

        if (buttons[i]->getToggleState())
            chosen.inputs.push_back (identifier);
    }

    host.setMidi (chosen);
    update();
}

void MidiPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);
    all.setBounds (area.removeFromTop (panelRowHeight));
    none.setBounds (area.withHeight (panelRowHeight));

    for (auto& button : buttons)
        button->setBounds (area.removeFromTop (panelRowHeight).withTrimmedLeft (2 * panelMargin));
}
} // namespace antinode
