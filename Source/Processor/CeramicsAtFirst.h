#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

namespace antinode
{
/** How many ceramics an instance has before a host asks for another number. LV2 bundles are made for a number each.
   VST3 hosts seldom ask: so the environment (ANTINODE_CERAMICS) can say it, else 32.
    @param ofBundle  that of the LV2 bundle
    [message thread] */
int ceramicsAtFirst (juce::AudioProcessor::WrapperType, int ofBundle);
} // namespace antinode
