#include "MainWindow.h"

#include "MainComponent.h"

namespace antinode
{
MainWindow::MainWindow (StandaloneHost& host) : DocumentWindow ("Antinode", juce::Colour (0xff1b2226), allButtons)
{
    setUsingNativeTitleBar (true);
    setResizable (true, false);
    setContentOwned (new MainComponent (host), true);
    centreWithSize (getWidth(), getHeight());
    setVisible (true);
    getContentComponent()->grabKeyboardFocus();
}
} // namespace antinode
