#include "TouchesButton.h"

#include <antinode_base/InputError.h>

namespace antinode
{
namespace
{
constexpr int firstOsc = 9000, firstTuio = 3333, pairs = 4; // as many instances can listen at once
constexpr auto here = "127.0.0.1", everywhere = "0.0.0.0";

juce::String portsText (const TouchPorts& ports)
{
    return "OSC " + juce::String (ports.oscPort) + ", TUIO " + juce::String (ports.tuioPort);
}
} // namespace

TouchesButton::TouchesButton (TouchProcessor& processorToSet) : processor (processorToSet)
{
    setTooltip ("Touches by OSC and TUIO put fingers down, move and lift them. Click to open ports for them.");
    onClick = [this] { showMenu(); };
    refresh();
}

void TouchesButton::refresh()
{
    const auto ports = processor.network().ports();
    const auto isOpen = ports.oscPort != 0 || ports.tuioPort != 0;
    const auto& touches = processor.network().touches();
    auto text = isOpen ? portsText (ports) + ": " + juce::String (touches.resting()) + " down"
                       : juce::String ("OSC, TUIO: off");

    if (const auto waiting = touches.waiting(); waiting > 0)
        text << ", " << juce::String (waiting) << " wait";

    setButtonText (text);
}

void TouchesButton::open (const TouchPorts& ports)
{
    try
    {
        failure.clear();
        processor.network().open (ports);
    }
    catch (const InputError& error)
    {
        failure = juce::String::fromUTF8 (error.what());
    }

    refresh();
}

void TouchesButton::showMenu()
{
    const auto now = processor.network().ports();
    juce::PopupMenu menu;
    menu.addItem ("Off", true, now.oscPort == 0 && now.tuioPort == 0, [this] { open ({ 0, 0, here }); });

    for (const auto* const address : { here, everywhere })
    {
        menu.addSectionHeader (juce::String (address) == here ? "From this computer" : "From the network");

        for (int i = 0; i < pairs; ++i)
        {
            const TouchPorts ports { firstOsc + i, firstTuio + i, address };
            const auto isOpen =
                ports.oscPort == now.oscPort && ports.tuioPort == now.tuioPort && ports.address == now.address;
            menu.addItem (portsText (ports), true, isOpen, [this, ports] { open (ports); });
        }
    }

    menu.setLookAndFeel (&getLookAndFeel());
    menu.showMenuAsync (juce::PopupMenu::Options().withTargetComponent (*this).withDeletionCheck (*this));
}
} // namespace antinode
