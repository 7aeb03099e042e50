#include "WindowRun.h"

#include "MainWindow.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>

namespace antinode
{
namespace
{
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
