#pragma once

#include <juce_core/juce_core.h>

namespace antinode
{
/** Draws the window of Antinode Touch while three fingers get their tracks. [message thread] */
void takeTouch (const juce::File&);
} // namespace antinode
