#include "MainWindow.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>

#include <algorithm>

namespace antinode
{
namespace
{
/** The program's window; closing it ends the message loop. */
class MainWindow : public juce::DocumentWindow
{
public:
    /** [message thread] needs a display */
    explicit MainWindow (std::unique_ptr<MainComponent> content);

    void closeButtonPressed() override { juce::MessageManager::getInstance()->stopDispatchLoop(); }

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
