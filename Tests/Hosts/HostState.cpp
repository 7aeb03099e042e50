#include "HostState.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <stdexcept>
#include <utility>

namespace antinode::test
{
namespace
{
/** Where an LV2 state has what the plug-in keeps: after the number of its bytes and a point. */
std::pair<std::size_t, std::size_t> encodedPart (const std::string& text)
{
    const auto encoding = text.find ("StateString");
    const auto from = text.find ('"', encoding) + 1;

    if (encoding == std::string::npos)
        throw std::runtime_error ("the LV2 state has no contents");

    return { from, text.find ('"', from) };
}
} // namespace

std::string innerState (PluginKind kind, const juce::MemoryBlock& state)
{
    juce::MemoryBlock inner;

    if (kind == PluginKind::vst3)
    {
        const auto xml = juce::AudioProcessor::getXmlFromBinary (state.getData(), static_cast<int> (state.getSize()));
        inner.fromBase64Encoding (xml->getChildByName ("IComponent")->getAllSubText());
    }
    else
    {
        const auto text = state.toString().toStdString();
        const auto [from, to] = encodedPart (text);
        inner.fromBase64Encoding (text.substr (from, to - from));
    }

    return { static_cast<const char*> (inner.getData()), inner.getSize() };
}

juce::MemoryBlock hostState (PluginKind kind, const juce::MemoryBlock& like, const std::string& inner)
{
    const auto encoded = juce::MemoryBlock (inner.data(), inner.size()).toBase64Encoding();
    juce::MemoryBlock state;

    if (kind == PluginKind::vst3)
    {
        juce::XmlElement xml ("VST3PluginState");
        xml.createNewChildElement ("IComponent")->addTextElement (encoded);
        juce::AudioProcessor::copyXmlToBinary (xml, state);
        return state;
    }

    auto text = like.toString().toStdString();
    const auto [from, to] = encodedPart (text);
    text.replace (from, to - from, encoded.toStdString());
    state.append (text.data(), text.size());
    return state;
}
} // namespace antinode::test
