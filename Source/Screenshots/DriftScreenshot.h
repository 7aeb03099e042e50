#pragma once

#include <juce_core/juce_core.h>

namespace antinode
{
/** Draws the editor while it tracks a staple that drifts, heard by an idle ceramic: a simulation. [message thread] */
void takeDrift (const juce::File&);
} // namespace antinode
