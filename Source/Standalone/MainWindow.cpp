#include "MainWindow.h"

#include "InputPanels.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int topHeight = 52, windowMargin = 8, windowGap = 6, settingsWidth = 430, muteWidth = 200,
              barButtonWidth = 90;
}

MainComponent::MainComponent (AudioHost& hostToUse, std::unique_ptr<ContentEditor> editor,
                              SettingsPanel::SeparateNodes nodes)
    : host (hostToUse), player (std::move (editor)), audio (host), routing (host), touch (host), bench (host),
      windowPanel (std::move (nodes))
{
    setLookAndFeel (&look);
    addAndMakeVisible (frame);
    frame.setInterceptsMouseClicks (false, true);
    player->setResizable (true, false); // The window has edges of its own.
    player->setContentScale (1);
    auto& content = player->content();
    content.moreMessages = [this] { return messages(); };
    content.setDark (host.settings().isDark);
    content.onTheme = [this] // What is dark or light is the editor.
    {
        host.setDark (player->content().isDark());
        showTheme();
    };
}

MainComponent::MainComponent (StandaloneHost& hostToUse)
    : MainComponent (hostToUse, std::make_unique<Editor> (hostToUse.processor()),
                     { [&hostToUse] { return hostToUse.processor().session().isGraphOpen(); },
                       [&hostToUse] (bool isOpen) { hostToUse.processor().session().setGraphOpen (isOpen); } })
{
    own = std::make_unique<MidiPanel> (hostToUse);
    fociEditor()->content().leaveSettingsToWindow();
    bench.device = [&hostToUse] { return hostToUse.processor().device(); };
    bench.onSaved = [this] (std::shared_ptr<const DeviceDocument> device)
    { fociEditor()->content().changeDevice (std::move (device)); };
    begin ({ "MIDI", "MIDI inputs that trigger foci.", own.get() });
}

MainComponent::MainComponent (TouchHost& hostToUse)
    : MainComponent (hostToUse, std::make_unique<TouchEditor> (hostToUse.processor()), {})
{
    own = std::make_unique<InputsPanel> (hostToUse);
    bench.device = [&hostToUse] { return hostToUse.processor().device(); };
    bench.onSaved = [&hostToUse] (std::shared_ptr<const DeviceDocument> device)
    { hostToUse.processor().load (std::move (device)); };
    touchEditor()->content().touches().setVisible (false); // The program's ports are a setting of its own.
    begin ({ "Inputs", "Input of the audio device that each finger feels.", own.get() });
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
    settingsButton.onClick = [this] { setSettingsVisible (settingsButton.getToggleState()); };
    windowPanel.setScale (host.settings().scale);
    windowPanel.onScale = [this] (double scale)
    {
        host.setScale (scale);
        resized();
    };
    settings.setPanels ({ { "Audio device", "Audio interface for the voltages.", &audio },
                          { "Routing", "Output and amplifier of each ceramic.", &routing },
                          ownPanel,
                          { "Touch", "Ports for touches: OSC and TUIO.", &touch },
                          { "Bench", "Measures the device point by point and retunes its drawing.", &bench },
                          { "Window", "Size of text and controls, and how what plays is run.", &windowPanel } });
    settings.show (openedAudio (host.devices()).type.empty() ? "Audio device" : "Routing");

    for (auto* const label : { &status, &latency })
        label->setFont (EditorLook::font());

    for (auto* const child :
         std::initializer_list<juce::Component*> { player.get(), &settings, &mute, &settingsButton, &status, &latency })
        frame.addAndMakeVisible (child);

    setWantsKeyboardFocus (true);
    setSize (player->getWidth() + settingsWidth, player->getHeight() + topHeight);
    resized();
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

juce::String MainComponent::statusText() const
{
    const auto opened = openedAudio (host.devices());

    if (opened.type.empty())
        return "No audio device";

    const auto name =
        juce::String::fromUTF8 (opened.type.c_str()) + " " + juce::String::fromUTF8 (opened.device.c_str());

    if (host.hasDeviceStopped())
        return name + " has stopped.";

    return name + ", " + juce::String (juce::roundToInt (opened.sampleRate)) + " Hz, " + juce::String (opened.blockSize)
           + " samples, " + juce::String (opened.outputs.size()) + " outputs, "
           + juce::String (std::max (0, host.devices().getXRunCount())) + " xruns, "
           + juce::String (juce::roundToInt (100 * host.devices().getCpuUsage())) + " % CPU";
}

/** For the status line of the editor, which has what plays to say beside it. */
std::vector<UserMessage> MainComponent::messages() const
{
    auto messages = host.messages();

    if (host.router().isMuted())
        addMessage (messages, Urgency::caution, "All outputs are muted until they are released.");

    if (openedAudio (host.devices()).type.empty() && host.message (MessageSource::audio).isEmpty())
        addMessage (messages, Urgency::warning, "No audio device is open. Choose one in Settings, Audio device.");

    return messages;
}

void MainComponent::showState()
{
    windowPanel.refresh();
    const auto& palette = look.palette();
    const auto isMuted = host.router().isMuted();
    mute.setButtonText (isMuted ? "MUTED: RELEASE" : "MUTE ALL");
    mute.setColour (juce::TextButton::buttonColourId, isMuted ? palette.raised : palette.warning);
    mute.setColour (juce::TextButton::textColourOffId, isMuted ? palette.warning : palette.onStrong);
    status.setText (statusText(), juce::dontSendNotification);
    status.setTooltip (status.getText());
    latency.setText (host.latencyText(), juce::dontSendNotification);
    latency.setTooltip (host.latencyAdviceText());
}

void MainComponent::showTheme()
{
    look.setPalette (player->content().isDark() ? Palette::dark() : Palette::light());
    const auto& palette = look.palette();
    latency.setColour (juce::Label::textColourId, palette.mutedText);
    settingsButton.setColour (juce::TextButton::buttonOnColourId, palette.raised);
    settingsButton.setColour (juce::TextButton::textColourOnId, palette.accent);
    sendLookAndFeelChange();
    showState();
}

void MainComponent::setSettingsVisible (bool areVisible)
{
    settings.setVisible (areVisible);
    settingsButton.setToggleState (areVisible, juce::dontSendNotification);
    resized();
}

void MainComponent::paint (juce::Graphics& g)
{
    g.fillAll (look.palette().window);
    g.setColour (look.palette().panel);
    g.fillRect (getLocalArea (&frame, frame.getLocalBounds().removeFromTop (topHeight - 1)));
}

/** Of the editor with what stands around it. */
ContentSizes MainComponent::sizes() const
{
    const auto beside = settings.isVisible() ? settingsWidth : 0;
    const auto& inside = player->content().shape().sizes;
    return { inside.leastWidth + beside, inside.leastHeight + topHeight, inside.roomyWidth + beside,
             inside.roomyHeight + topHeight };
}

void MainComponent::resized()
{
    if (getWidth() == 0)
        return;

    const auto scale = windowScale (getWidth(), getHeight(), sizes(), host.settings().scale);
    frame.setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
    frame.setBounds (0, 0, juce::roundToInt (getWidth() / scale), juce::roundToInt (getHeight() / scale));
    layOut (frame.getLocalBounds());
    repaint();
}

void MainComponent::layOut (juce::Rectangle<int> area)
{
    auto top = area.removeFromTop (topHeight).reduced (windowMargin, windowMargin - 1);
    mute.setBounds (top.removeFromRight (muteWidth));
    top.removeFromRight (windowMargin);
    settingsButton.setBounds (top.removeFromRight (barButtonWidth));
    top.removeFromRight (windowMargin);
    status.setBounds (top.removeFromTop (top.getHeight() / 2));
    latency.setBounds (top);

    if (settings.isVisible())
        settings.setBounds (area.removeFromRight (settingsWidth).withTrimmedTop (windowGap));

    player->setBounds (area);
}

namespace
{
/** The program's window; closing it ends the message loop. */
class MainWindow : public juce::DocumentWindow
{
public:
    /** [message thread] needs a display */
    explicit MainWindow (std::unique_ptr<MainComponent> content);

    void closeButtonPressed() override { juce::MessageManager::getInstance()->stopDispatchLoop(); }

    /** Where nothing has the keyboard, as after a focused button was disabled: F12 and Escape work always. */
    bool keyPressed (const juce::KeyPress& key) override { return getContentComponent()->keyPressed (key); }

private:
    static constexpr int maximumSize = 16384;

    /** Keeps the window on the screen: MUTE ALL must stay clickable. */
    void fitToScreen();
};

MainWindow::MainWindow (std::unique_ptr<MainComponent> content)
    : DocumentWindow ("Antinode", Palette::dark().window, allButtons)
{
    setUsingNativeTitleBar (true);
    setResizable (true, false);
    setContentOwned (content.release(), true);
    fitToScreen();
    setVisible (true);
    getContentComponent()->grabKeyboardFocus();
}

void MainWindow::fitToScreen()
{
    constexpr int frame = 40; // of a title bar that is not there yet
    auto width = getWidth(), height = getHeight();

    if (const auto* const screen = juce::Desktop::getInstance().getDisplays().getPrimaryDisplay())
    {
        width = std::min (width, screen->userArea.getWidth());
        height = std::min (height, screen->userArea.getHeight() - frame);
    }

    setResizeLimits (std::min (width, MainComponent::minimumWidth), std::min (height, MainComponent::minimumHeight),
                     maximumSize, maximumSize);
    centreWithSize (width, height);
}

/** Ends the message loop when the program is interrupted. */
class InterruptionWatch : private juce::Timer
{
public:
    InterruptionWatch() { startTimer (20); }

private:
    void timerCallback() override
    {
        if (isInterrupted())
            juce::MessageManager::getInstance()->stopDispatchLoop();
    }
};
} // namespace

void runWithWindow (const std::function<std::unique_ptr<MainComponent>()>& makeContent)
{
    // Only in what JUCE knows as a program of its own does it use X from several threads safely and outlive X's errors.
    juce::JUCEApplicationBase::createInstance = []() -> juce::JUCEApplicationBase* { return nullptr; };

    if (juce::Desktop::getInstance().getDisplays().displays.isEmpty())
        throw InputError ("", "no display is available; --headless plays without a window");

    const MainWindow window (makeContent());
    const InterruptionWatch watch;
    juce::MessageManager::getInstance()->runDispatchLoop();
}
} // namespace antinode
