#include "MainComponent.h"

#include "MidiPanel.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int topHeight = 52, windowMargin = 8, windowGap = 6, settingsWidth = 430, muteWidth = 200,
              barButtonWidth = 90;
}

MainComponent::MainComponent (AudioHost& hostToUse, std::unique_ptr<juce::AudioProcessorEditor> editor)
    : host (hostToUse), player (std::move (editor)), audio (host), routing (host), touch (host)
{
    setLookAndFeel (&look);
    // The window has edges of its own.
    player->setResizable (true, false);
}

MainComponent::MainComponent (StandaloneHost& hostToUse)
    : MainComponent (hostToUse, std::make_unique<Editor> (hostToUse.processor()))
{
    own = std::make_unique<MidiPanel> (hostToUse);
    followTheme (fociEditor()->content());
    begin ({ "MIDI", "MIDI inputs that trigger foci.", own.get() });
}

MainComponent::MainComponent (TouchHost& hostToUse)
    : MainComponent (hostToUse, std::make_unique<TouchEditor> (hostToUse.processor()))
{
    own = std::make_unique<InputsPanel> (hostToUse);
    followTheme (touchEditor()->content());
    touchEditor()->content().touches().setVisible (false); // The program's ports are a setting of its own.
    begin ({ "Inputs", "Input of the audio device that each finger feels.", own.get() });
}

/** What is dark or light is the editor. */
template <typename Content>
void MainComponent::followTheme (Content& content)
{
    content.setDark (host.settings().isDark);
    isEditorDark = [&content] { return content.isDark(); };
    content.onTheme = [this]
    {
        host.setDark (isEditorDark());
        showTheme();
    };
}

void MainComponent::begin (const PanelGroup::Panel& ownPanel)
{
    mute.onClick = [this]
    {
        if (host.router().isMuted())
            host.router().release();
        else
            host.muteAll();

        showState();
    };
    mute.setTooltip ("Sets all outputs to 0 V until they are released here. Key: F12");
    settingsButton.setClickingTogglesState (true);
    settingsButton.setToggleState (true, juce::dontSendNotification);
    settingsButton.setTooltip ("Shows or hides the settings at the right");
    settingsButton.onClick = [this]
    {
        settings.setVisible (settingsButton.getToggleState());
        resized();
    };
    settings.setPanels ({ { "Audio device", "Audio interface for the voltages.", &audio },
                          { "Routing", "Output and amplifier of each ceramic.", &routing },
                          ownPanel,
                          { "Touch", "Ports for touches: OSC and TUIO.", &touch } });
    settings.show (openedAudio (host.devices()).type.empty() ? "Audio device" : "Routing");

    for (auto* const label : { &status, &warning })
        label->setFont (EditorLook::font());

    for (auto* const child :
         std::initializer_list<juce::Component*> { player.get(), &settings, &mute, &settingsButton, &status, &warning })
        addAndMakeVisible (child);

    setWantsKeyboardFocus (true);
    setSize (player->getWidth() + settingsWidth, player->getHeight() + topHeight);
    host.onChange = [this] { update(); };
    showTheme();
    startTimerHz (10);
}

MainComponent::~MainComponent()
{
    host.onChange = nullptr;
    player = nullptr;
    setLookAndFeel (nullptr);
}

void MainComponent::update()
{
    routing.update();
    audio.update();

    if (auto* const inputs = dynamic_cast<InputsPanel*> (own.get()))
        inputs->update();
}

bool MainComponent::keyPressed (const juce::KeyPress& key)
{
    if (key == juce::KeyPress (juce::KeyPress::F12Key))
        host.muteAll();
    else if (key == juce::KeyPress (juce::KeyPress::escapeKey))
    {
        host.stopAll();
        host.router().identify (OutputRouting::none);
    }
    else
        return false;

    showState();
    return true;
}

juce::String MainComponent::statusText (const juce::String& latency) const
{
    const auto opened = openedAudio (host.devices());

    if (opened.type.empty())
        return "No audio device is open. Choose one in Settings, Audio device.";

    const auto name =
        juce::String::fromUTF8 (opened.type.c_str()) + " " + juce::String::fromUTF8 (opened.device.c_str());

    if (host.hasDeviceStopped())
        return name + " has stopped.";

    return name + ", " + juce::String (juce::roundToInt (opened.sampleRate)) + " Hz, " + juce::String (opened.blockSize)
           + " samples, " + juce::String (opened.outputs.size()) + " outputs, "
           + juce::String (std::max (0, host.devices().getXRunCount())) + " xruns, "
           + juce::String (juce::roundToInt (100 * host.devices().getCpuUsage())) + " % CPU"
           + (latency.isNotEmpty() ? "; " + latency : juce::String());
}

juce::String MainComponent::warningText() const
{
    if (host.router().isMuted())
        return "All outputs are muted until they are released.";

    return host.warning();
}

void MainComponent::showState()
{
    const auto& palette = look.palette();
    const auto isMuted = host.router().isMuted();
    mute.setButtonText (isMuted ? "MUTED: RELEASE" : "MUTE ALL");
    mute.setColour (juce::TextButton::buttonColourId, isMuted ? palette.raised : palette.warning);
    mute.setColour (juce::TextButton::textColourOffId, isMuted ? palette.warning : palette.onStrong);
    status.setText (statusText (host.latencyText()), juce::dontSendNotification);
    status.setTooltip (host.latencyAdviceText());
    warning.setText (warningText(), juce::dontSendNotification);
    warning.setTooltip (warning.getText());
}

void MainComponent::showTheme()
{
    look.setPalette (isEditorDark() ? Palette::dark() : Palette::light());
    const auto& palette = look.palette();
    warning.setColour (juce::Label::textColourId, palette.warning);
    settingsButton.setColour (juce::TextButton::buttonOnColourId, palette.raised);
    settingsButton.setColour (juce::TextButton::textColourOnId, palette.accent);
    sendLookAndFeelChange();
    showState();
}

void MainComponent::paint (juce::Graphics& g)
{
    g.fillAll (look.palette().window);
    g.setColour (look.palette().panel);
    g.fillRect (getLocalBounds().removeFromTop (topHeight - 1));
}

void MainComponent::resized()
{
    auto area = getLocalBounds();
    auto top = area.removeFromTop (topHeight).reduced (windowMargin, windowMargin - 1);
    mute.setBounds (top.removeFromRight (muteWidth));
    top.removeFromRight (windowMargin);
    settingsButton.setBounds (top.removeFromRight (barButtonWidth));
    top.removeFromRight (windowMargin);
    status.setBounds (top.removeFromTop (top.getHeight() / 2));
    warning.setBounds (top);

    if (settings.isVisible())
        settings.setBounds (area.removeFromRight (settingsWidth).withTrimmedTop (windowGap));

    player->setBounds (area);
}
} // namespace antinode
