#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

#include <chrono>
#include <thread>

namespace antinode
{
/** Writes a picture of a component, and says so. [message thread] */
void writePicture (juce::Component&, const juce::File&);

/** Refreshes a window's content until it shows what is wanted. [message thread] */
template <typename Content, typename IsReached>
void refreshUntil (Content& content, const IsReached& isReached)
{
    do
    {
        std::this_thread::sleep_for (std::chrono::milliseconds (10));
        content.refresh (0);
    } while (! isReached());
}

/** Antinode, while a device is drawn, with a ceramic that is dragged too near the edge. */
void takeDevice (const juce::File&, int width, int height, bool isDark);

/** Antinode, while a drifting staple is followed. */
void takeDrift (const juce::File&);

/** Antinode Plate, with a window of a focus on glass. */
void takePlate (const juce::File&);

/** Antinode Touch with four fingers on glass, and the standalone program with the same. */
void takeTouch (const juce::File&);
void takeTouchStandalone (const juce::File&);
} // namespace antinode
