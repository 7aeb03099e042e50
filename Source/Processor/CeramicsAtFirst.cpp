#include "CeramicsAtFirst.h"

#include "DeviceProcessor.h"

#include <cstdlib>

namespace antinode
{
int ceramicsAtFirst (juce::AudioProcessor::WrapperType wrapper, int ofBundle)
{
    constexpr int usual = 32;

    if (wrapper != juce::AudioProcessor::wrapperType_VST3)
        return ofBundle;

    const auto* const wanted = std::getenv ("ANTINODE_CERAMICS");
    const auto number = wanted != nullptr ? juce::String (wanted).getIntValue() : usual;
    return number >= 1 && number <= DeviceProcessor::maximumCeramics ? number : usual;
}
} // namespace antinode
