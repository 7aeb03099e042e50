#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <vector>

namespace antinode
{
/** How many ceramics an instance has before a host asks for another number. LV2 bundles are made for a number each.
   VST3 hosts seldom ask: so the environment (ANTINODE_CERAMICS) can say it, else 32.
    @param ofBundle  that of the LV2 bundle
    [message thread] */
int ceramicsAtFirst (juce::AudioProcessor::WrapperType, int ofBundle);

/** The layout of the given number of channels whose wires we name: the set of the lowest VST3 speaker bits. Discrete
   layouts crash JUCE's VST3 wrapper, named ones are permuted. [any] @param channels  1 to 64 */
juce::AudioChannelSet vst3ChannelSet (int channels);

/** The channel of a buffer with this layout that becomes wire k in VST3. [worker] @return  as many as the layout has */
std::vector<int> vst3ChannelOrder (const juce::AudioChannelSet&);

/** The layout of a number of channels for what a plug-in runs in: VST3 needs its own. [any] @param channels  1 to 64 */
juce::AudioChannelSet wireSet (int channels, juce::AudioProcessor::WrapperType);

/** The channel of a buffer with this layout that is wire k in what a plug-in runs in. [worker] */
std::vector<int> wireOrder (const juce::AudioChannelSet&, juce::AudioProcessor::WrapperType);
} // namespace antinode
