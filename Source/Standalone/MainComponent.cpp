#include "MainComponent.h"

#include "AudioPanel.h"
#include "MidiPanel.h"
#include "RoutingPanel.h"
#include "TouchPanel.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int topHeight = 64, margin = 8, tabsWidth = 460, muteWidth = 220, leastPlayerWidth = 420, leastHeight = 560;
}

MainComponent::MainComponent (StandaloneHost& hostToUse) : host (hostToUse)
{
    setLookAndFeel (&look);

    player.reset (host.processor().createEditor());
    mute.onClick = [this]
    {
        if (host.router().isMuted())
            host.router().release();
        else
            host.muteAll();

        showState();
    };
    mute.setTooltip ("Escape or F12: all outputs to 0 V until they are released here");
    showSettings.setClickingTogglesState (true);
    showSettings.setToggleState (true, juce::dontSendNotification);
    showSettings.onClick = [this]
    {
        tabs.setVisible (showSettings.getToggleState());
        resized();
    };
    warning.setColour (juce::Label::textColourId, StandaloneLook::warning());
    addTabs();

    for (auto* const child :
         std::initializer_list<juce::Component*> { player.get(), &tabs, &mute, &showSettings, &status, &warning })
        addAndMakeVisible (child);

    setWantsKeyboardFocus (true);
    setSize (std::max (player->getWidth(), leastPlayerWidth) + tabsWidth,
             std::max (player->getHeight(), leastHeight) + topHeight);
    host.onChange = [this]
    {
        routingPanel->update();
        audioPanel->update();
    };
    showState();
    startTimerHz (10);
}

MainComponent::~MainComponent()
{
    host.onChange = nullptr;
    tabs.clearTabs();
    player.reset();
    setLookAndFeel (nullptr);
}

void MainComponent::addTabs()
{
    const auto colour = look.findColour (juce::TabbedComponent::backgroundColourId);
    auto devices = std::make_unique<AudioPanel> (host);
    audioPanel = devices.get();
    auto routes = std::make_unique<RoutingPanel> (host);
    routingPanel = routes.get();
    tabs.addTab ("Audio device", colour, devices.release(), true);
    tabs.addTab ("Routing", colour, routes.release(), true);
    tabs.addTab ("MIDI", colour, std::make_unique<MidiPanel> (host).release(), true);
    tabs.addTab ("Touch", colour, std::make_unique<TouchPanel> (host).release(), true);
    tabs.setCurrentTabIndex (1);
}

bool MainComponent::keyPressed (const juce::KeyPress& key)
{
    if (key != juce::KeyPress (juce::KeyPress::escapeKey) && key != juce::KeyPress (juce::KeyPress::F12Key))
        return false;

    host.muteAll();
    showState();
    return true;
}

juce::String MainComponent::statusText() const
{
    const auto audio = openedAudio (host.devices());

    if (audio.type.empty())
        return "No audio device is open.";

    return juce::String::fromUTF8 (audio.type.c_str()) + " " + juce::String::fromUTF8 (audio.device.c_str()) + ", "
           + juce::String (juce::roundToInt (audio.sampleRate)) + " Hz, " + juce::String (audio.blockSize)
           + " samples, " + juce::String (audio.outputs.size()) + " outputs, "
           + juce::String (std::max (0, host.devices().getXRunCount())) + " xruns, "
           + juce::String (juce::roundToInt (100 * host.devices().getCpuUsage())) + " % CPU";
}

void MainComponent::showState()
{
    const auto isMuted = host.router().isMuted();
    mute.setButtonText (isMuted ? "MUTED: release" : "MUTE ALL");
    mute.setColour (juce::TextButton::buttonColourId,
                    isMuted ? StandaloneLook::danger().darker (0.9F) : StandaloneLook::danger());
    status.setText (statusText(), juce::dontSendNotification);
    warning.setText (host.warning(), juce::dontSendNotification);
}

void MainComponent::paint (juce::Graphics& g)
{
    g.fillAll (look.findColour (juce::ResizableWindow::backgroundColourId));
}

void MainComponent::childBoundsChanged (juce::Component* child)
{
    if (child == player.get())
        resized();
}

void MainComponent::resized()
{
    auto area = getLocalBounds();
    auto top = area.removeFromTop (topHeight).reduced (margin);
    mute.setBounds (top.removeFromRight (muteWidth));
    top.removeFromRight (margin);
    showSettings.setBounds (top.removeFromRight (90).withSizeKeepingCentre (90, 30));
    status.setBounds (top.removeFromTop (top.getHeight() / 2));
    warning.setBounds (top);

    if (tabs.isVisible())
        tabs.setBounds (area.removeFromRight (tabsWidth).reduced (margin));

    player->setBounds (area);
}
} // namespace antinode
