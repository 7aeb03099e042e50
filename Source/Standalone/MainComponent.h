#pragma once

#include "StandaloneHost.h"
#include "StandaloneLook.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>

namespace antinode
{
class AudioPanel;
class RoutingPanel;

/** All that is in the window: MUTE ALL on top, the player's editor, and the settings beside it. */
class MainComponent : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit MainComponent (StandaloneHost& hostToUse);
    ~MainComponent() override;

    /** Escape and F12 mute everything. */
    bool keyPressed (const juce::KeyPress&) override;

    void paint (juce::Graphics&) override;
    void resized() override;
    void childBoundsChanged (juce::Component*) override;

private:
    void addTabs();
    void timerCallback() override { showState(); }
    void showState();
    juce::String statusText() const;

    StandaloneHost& host;
    StandaloneLook look;
    std::unique_ptr<juce::Component> player; ///< The editor.
    juce::TabbedComponent tabs { juce::TabbedButtonBar::TabsAtTop };
    juce::TextButton mute, showSettings { "Settings" };
    juce::Label status, warning;
    AudioPanel* audioPanel = nullptr; ///< In the tabs, as the next one.
    RoutingPanel* routingPanel = nullptr;
    juce::TooltipWindow tooltips { this };
};
} // namespace antinode
