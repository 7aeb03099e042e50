#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

namespace antinode
{
/** The effect of a parameter and its range with the unit, for tooltips and screen readers. [message thread] */
juce::String helpText (const juce::RangedAudioParameter&);
} // namespace antinode
