#pragma once

#include <juce_core/juce_core.h>

namespace antinode
{
/** Draws Antinode Plate with a window of the motion that the demonstrator's glass plate makes, into a file.
    [message thread] */
void takePlate (const juce::File&);
} // namespace antinode
