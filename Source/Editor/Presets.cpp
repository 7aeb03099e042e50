#include "Presets.h"

#include <antinode_files/FocusFile.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
/** Does something that may fail with a sentence. */
template <typename Action>
juce::String sentenceOf (const Action& action)
{
    try
    {
        action();
        return {};
    }
    catch (const std::exception& failure)
    {
        return juce::String::fromUTF8 (failure.what());
    }
}
} // namespace

Presets::Presets (AntinodeProcessor& processorToLoad, History& historyToKeep)
    : processor (processorToLoad), history (historyToKeep)
{
}

juce::String Presets::load (LibraryKind kind, const std::string& nameOrFile)
{
    return sentenceOf (
        [&]
        {
            const auto source = documentSource (kind, nameOrFile);
            const auto json = loadDocument (kind, nameOrFile);

            if (kind == LibraryKind::device)
            {
                auto device = std::make_shared<const DeviceDocument> (readDeviceDocument (json, source));
                history.record ([&] { processor.load (std::move (device), nullptr); });
            }
            else
            {
                auto focus = std::make_shared<const FocusDocument> (readFocusDocument (json, source));
                history.record ([&] { processor.load (nullptr, std::move (focus)); });
            }
        });
}

juce::String Presets::save (LibraryKind kind, const std::string& name)
{
    return sentenceOf (
        [&]
        {
            if (kind == LibraryKind::device)
            {
                auto json = nlohmann::ordered_json::parse (processor.device()->text);
                json["name"] = name;
                saveDocument (kind, name, json);
                return;
            }

            auto focus = withSettings (processor.focus()->description, processor.parameters().settings(),
                                       extentOf (processor.device()->description));
            focus.name = name;
            saveDocument (kind, name, focusToJson (focus));
        });
}

juce::String Presets::remove (LibraryKind kind, const std::string& name)
{
    return sentenceOf ([&] { removeDocument (kind, name); });
}

juce::String Presets::loadedName (LibraryKind kind) const
{
    const auto& name =
        kind == LibraryKind::device ? processor.device()->description.name : processor.focus()->description.name;
    return name.empty() ? juce::String ("without a name") : juce::String::fromUTF8 (name.c_str());
}
} // namespace antinode
