#pragma once

#include "AudioPanel.h"
#include "BenchPanel.h"
#include "InputPanels.h"
#include "RoutingPanel.h"
#include "StandaloneHost.h"
#include "TouchHost.h"

#include <Editor/EditorContent.h>
#include <Touch/TouchContent.h>

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** The content of the window: MUTE ALL on top, the editor, and the settings at the right. */
class MainComponent final : public juce::Component, private juce::Timer
{
public:
    /** The least size of a window, in pixels: there all is reachable, though small. */
    static constexpr int minimumWidth = 640, minimumHeight = 400;

    /** Foci. @param hostToUse  outlives this [message thread] */
    explicit MainComponent (StandaloneHost& hostToUse);

    /** Fingers. @param hostToUse  outlives this [message thread] */
    explicit MainComponent (TouchHost& hostToUse);
    ~MainComponent() override;

    /** The one of what plays; the other is none. */
    Editor* fociEditor() { return dynamic_cast<Editor*> (player.get()); }
    TouchEditor* touchEditor() { return dynamic_cast<TouchEditor*> (player.get()); }

    /** Shows the routing and the audio device as they are now. [message thread] */
    void update();

    BenchPanel& benchPanel() { return bench; }

    /** Shows one of the settings: "Audio device", "Routing", "MIDI" or "Inputs", "Touch", "Bench", "Window". [message
        thread] */
    void showSettings (const juce::String& name) { settings.show (name); }

    /** Shows or hides the settings. [message thread] */
    void setSettingsVisible (bool);

    /** F12 mutes everything, Escape ends all that plays. */
    bool keyPressed (const juce::KeyPress&) override;

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    MainComponent (AudioHost& hostToUse, std::unique_ptr<ContentEditor> editor, SettingsPanel::SeparateNodes);

    void begin (const PanelGroup::Panel& ownPanel);
    void layOut (juce::Rectangle<int>);
    ContentSizes sizes() const;
    void timerCallback() override { showState(); }
    void showState();
    void showTheme();
    juce::String statusText() const;
    std::vector<UserMessage> messages() const;

    AudioHost& host;
    EditorLook look;
    juce::Component frame; ///< All that is seen, at scale 1.
    std::unique_ptr<ContentEditor> player;
    AudioPanel audio;
    RoutingPanel routing;
    std::unique_ptr<juce::Component> own; ///< The panel that only foci or only fingers have.
    TouchPanel touch;
    BenchPanel bench;
    SettingsPanel windowPanel;
    PanelGroup settings { "Settings" };
    juce::TextButton mute, settingsButton { "Settings" };
    juce::Label status, latency;
    LocalTooltips tooltips { &frame, 600 };
};

/** Shows the window until it is closed or the user interrupts the program.
    @param makeContent  called where there is a display
    @throws InputError  where there is no display
    [message thread] runs the message loop */
void runWithWindow (const std::function<std::unique_ptr<MainComponent>()>& makeContent);
} // namespace antinode
