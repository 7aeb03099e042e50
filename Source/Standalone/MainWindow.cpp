#include "MainWindow.h"

#include <algorithm>

namespace antinode
{
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
} // namespace antinode
