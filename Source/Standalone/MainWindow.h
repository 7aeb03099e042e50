#pragma once

#include "StandaloneHost.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** The program's window; closing it ends the message loop. */
class MainWindow : public juce::DocumentWindow
{
public:
    /** @param host  outlives this [message thread] needs a display */
    explicit MainWindow (StandaloneHost& host);

    void closeButtonPressed() override { juce::MessageManager::getInstance()->stopDispatchLoop(); }

private:
    static constexpr int maximumSize = 16384;

    /** Keeps the window on the screen: MUTE ALL must stay clickable. */
    void fitToScreen();
};
} // namespace antinode
