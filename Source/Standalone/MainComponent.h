#pragma once

#include "AudioPanel.h"
#include "MidiPanel.h"
#include "RoutingPanel.h"
#include "TouchPanel.h"
#include "TriggerLatency.h"

#include <Editor/Editor.h>

namespace antinode
{
/** The content of the window: MUTE ALL on top, the editor, and the settings at the right. */
class MainComponent final : public juce::Component, private juce::Timer
{
public:
    /** The least size at which everything is legible, in pixels. */
    static constexpr int minimumWidth = 1100, minimumHeight = 560;

    /** @param hostToUse  outlives this [message thread] */
    explicit MainComponent (StandaloneHost& hostToUse);
    ~MainComponent() override;

    Editor& editor() { return player; }

    /** Shows the routing and the audio device as they are now. [message thread] */
    void update();

    /** Shows one of the settings: "Audio device", "Routing", "MIDI", "Touch". [message thread] */
    void showSettings (const juce::String& name) { settings.show (name); }

    /** F12 mutes everything, Escape ends all that plays. */
    bool keyPressed (const juce::KeyPress&) override;

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    void timerCallback() override { showState(); }
    void showState();
    void showTheme();
    juce::String statusText (const std::optional<TriggerLatency>&) const;
    juce::String warningText() const;

    StandaloneHost& host;
    EditorLook look;
    Editor player;
    AudioPanel audio;
    RoutingPanel routing;
    MidiPanel midi;
    TouchPanel touch;
    PanelGroup settings { "Settings" };
    juce::TextButton mute, settingsButton { "Settings" };
    juce::Label status, warning;
    LocalTooltips tooltips { this, 600 };
};
} // namespace antinode
