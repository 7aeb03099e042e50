#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

namespace antinode
{
/** What a parameter does, and the values that it can have with their unit: for tooltips and screen readers. [message thread] */
juce::String helpOf (const juce::RangedAudioParameter&);
} // namespace antinode
