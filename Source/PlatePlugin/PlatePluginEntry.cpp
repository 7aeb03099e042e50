#include <PlateEditor/InstallPlateEditor.h>
#include <PlateProcessor/PlateProcessor.h>

#include <cstdlib>

#ifndef ANTINODE_LV2_CERAMICS
#define ANTINODE_LV2_CERAMICS 8
#endif

namespace
{
/** How many ceramics an instance has before a host asks for another number, as in the instrument. */
int ceramicsAtFirst (juce::AudioProcessor::WrapperType wrapper)
{
    constexpr int usual = 32;

    if (wrapper != juce::AudioProcessor::wrapperType_VST3)
        return ANTINODE_LV2_CERAMICS;

    const auto* const wanted = std::getenv ("ANTINODE_CERAMICS");
    const auto number = wanted != nullptr ? juce::String (wanted).getIntValue() : usual;
    return number >= 1 && number <= antinode::PlateProcessor::maximumCeramics ? number : usual;
}
} // namespace

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter();

juce::AudioProcessor* JUCE_CALLTYPE createPluginFilter()
{
    antinode::installPlateEditor();
    const auto wrapper = juce::PluginHostType::getPluginLoadedAs();
    return new antinode::PlateProcessor (ceramicsAtFirst (wrapper), wrapper);
}
