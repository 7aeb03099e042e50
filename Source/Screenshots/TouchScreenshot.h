#pragma once

#include <juce_core/juce_core.h>

namespace antinode
{
/** Draws the window of Antinode Touch while three fingers get their tracks. [message thread] */
void takeTouch (const juce::File&);

/** The same in the standalone program. [message thread] */
void takeTouchStandalone (const juce::File&);
} // namespace antinode
