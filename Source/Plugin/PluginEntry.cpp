#include <Editor/InstallEditor.h>
#include <Processor/AntinodeProcessor.h>

#include <cstdlib>

#ifndef ANTINODE_LV2_CERAMICS
#define ANTINODE_LV2_CERAMICS 8
#endif

namespace
{
/** How many ceramics an instance has before a host asks for another number. LV2 bundles are made for a number each.
   VST3 hosts seldom ask: so the environment can say it. */
int ceramicsAtFirst (juce::AudioProcessor::WrapperType wrapper)
{
    constexpr int usual = 32;

    if (wrapper != juce::AudioProcessor::wrapperType_VST3)
        return ANTINODE_LV2_CERAMICS;

    const auto* const wanted = std::getenv ("ANTINODE_CERAMICS");
    const auto number = wanted != nullptr ? juce::String (wanted).getIntValue() : usual;
    return number >= 1 && number <= antinode::AntinodeProcessor::maximumCeramics ? number : usual;
}
} // namespace

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter()
{
    antinode::installEditor();
    const auto wrapper = juce::PluginHostType::getPluginLoadedAs();
    return new antinode::AntinodeProcessor (ceramicsAtFirst (wrapper), wrapper);
}
