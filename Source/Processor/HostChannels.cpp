#include "HostChannels.h"

#include "DeviceProcessor.h"

// JUCE keeps the mapping in a header of its own module, which wants the VST3 headers before it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#define JUCE_VST3HEADERS_INCLUDE_HEADERS_ONLY 1
#include <juce_audio_processors/format_types/juce_VST3Headers.h>

#include <juce_audio_processors/utilities/juce_FlagCache.h>

#include <juce_audio_processors/format_types/juce_VST3Common.h>
#pragma GCC diagnostic pop

#include <cstdlib>
#include <numeric>
#include <type_traits>

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

namespace
{
/** JUCE 7 has a set for all speakers; JUCE 8 gives it as an optional, empty where it has none. */
template <typename Set>
juce::AudioChannelSet setOrDiscrete (const Set& set, int channels)
{
    if constexpr (std::is_same_v<Set, juce::AudioChannelSet>)
        return set;
    else
        return set.value_or (juce::AudioChannelSet::discreteChannels (channels));
}
} // namespace

juce::AudioChannelSet vst3ChannelSet (int channels)
{
    const auto speakers = channels >= 64 ? ~0ULL : (1ULL << channels) - 1;
    return setOrDiscrete (juce::getChannelSetForSpeakerArrangement (speakers), channels);
}

std::vector<int> vst3ChannelOrder (const juce::AudioChannelSet& layout)
{
    const juce::ChannelMapping mapping (layout);
    std::vector<int> order;
    order.reserve (static_cast<std::size_t> (layout.size()));

    for (int wire = 0; wire < layout.size(); ++wire)
        order.push_back (mapping.getJuceChannelForVst3Channel (wire));

    return order;
}

juce::AudioChannelSet wireSet (int channels, juce::AudioProcessor::WrapperType wrapper)
{
    return wrapper == juce::AudioProcessor::wrapperType_VST3 ? vst3ChannelSet (channels)
                                                             : juce::AudioChannelSet::discreteChannels (channels);
}

std::vector<int> wireOrder (const juce::AudioChannelSet& layout, juce::AudioProcessor::WrapperType wrapper)
{
    if (wrapper == juce::AudioProcessor::wrapperType_VST3)
        return vst3ChannelOrder (layout);

    std::vector<int> order (static_cast<std::size_t> (layout.size()));
    std::iota (order.begin(), order.end(), 0);
    return order;
}
} // namespace antinode
