#pragma once

#include "MainComponent.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>

namespace antinode
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
} // namespace antinode
