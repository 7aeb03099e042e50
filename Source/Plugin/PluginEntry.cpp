#include <Editor/EditorContent.h>
#include <Processor/AntinodeProcessor.h>
#include <Processor/HostChannels.h>

#ifndef ANTINODE_LV2_CERAMICS
#define ANTINODE_LV2_CERAMICS 8
#endif

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter()
{
    antinode::installEditor();
    const auto wrapper = juce::PluginHostType::getPluginLoadedAs();
    return new antinode::AntinodeProcessor (antinode::ceramicsAtFirst (wrapper, ANTINODE_LV2_CERAMICS), wrapper);
}
