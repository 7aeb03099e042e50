#include "Presets.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_session/WrittenDesign.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
/** Does something that may fail with a sentence. */
template <typename Action>
juce::String attemptAction (const Action& action)
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

/** Puts a device or focus of the library, or of a file, into a state. */
void read (LibraryKind kind, const std::string& nameOrFile, SessionState& state)
{
    if (kind == LibraryKind::device)
        state.device = deviceDocument (nameOrFile);
    else
        state.focus = focusDocument (nameOrFile);
}

/** The loaded device under another name. */
nlohmann::ordered_json deviceNamed (const AntinodeProcessor& processor, const std::string& name)
{
    auto json = nlohmann::ordered_json::parse (processor.device()->text);
    json["name"] = name;
    return json;
}

/** The loaded focus as the parameters changed it, under another name. */
nlohmann::ordered_json focusNamed (AntinodeProcessor& processor, const std::string& name)
{
    const auto document = processor.state().focus;
    auto focus = withSettings (document->description, processor.parameters().settings(),
                               deviceExtent (processor.device()->description));

    if (writtenFor (*document, focus) != nullptr)
        throw InputError (document->design->source,
                          "is a written design, which its file and sessions keep; move a parameter to save its focus");

    focus.name = name;
    return focusToJson (focus);
}
/** A design for another device or rate changes nothing. */
void requirePlayable (AntinodeProcessor& processor, const FocusDocument& focus)
{
    const auto now = processor.session().snapshot();
    const auto& device = *processor.device();
    const auto isSolved = now->device != nullptr && now->device->text == device.text;
    requireFit (focus, device, isSolved ? now->model.get() : nullptr, now->playback);
}

LibraryKind kindOf (const nlohmann::json& document)
{
    const auto schema = document.is_object() ? document.value ("schema", nlohmann::json()) : nlohmann::json();
    const auto isDevice = schema.is_string() && schema.get<std::string>().starts_with ("antinode.device/");
    return isDevice ? LibraryKind::device : LibraryKind::focus;
}
} // namespace

Presets::Presets (AntinodeProcessor& processorToLoad, History& historyToKeep)
    : processor (processorToLoad), history (historyToKeep)
{
}

juce::String Presets::load (LibraryKind kind, const std::string& nameOrFile)
{
    return attemptAction (
        [&]
        {
            auto wanted = processor.state();
            read (kind, nameOrFile, wanted);

            if (kind == LibraryKind::device)
                history.record ([&] { processor.load (wanted.device, nullptr); });
            else
            {
                requirePlayable (processor, *wanted.focus);
                history.record ([&] { processor.load (nullptr, wanted.focus); });
            }
        });
}

juce::String Presets::loadFile (const std::string& file)
{
    auto kind = LibraryKind::focus;
    const auto failure = attemptAction ([&] { kind = kindOf (readJsonFile (file)); });
    return failure.isEmpty() ? load (kind, file) : failure;
}

juce::String Presets::save (LibraryKind kind, const std::string& name)
{
    return attemptAction (
        [&]
        {
            saveDocument (kind, name,
                          kind == LibraryKind::device ? deviceNamed (processor, name) : focusNamed (processor, name));
            auto wanted = processor.state();
            read (kind, name, wanted);
            // Not loaded: what is armed, muted and set stays.
            history.record ([&] { processor.setState (wanted, false); });
        });
}

juce::String Presets::remove (LibraryKind kind, const std::string& name)
{
    return attemptAction ([&] { removeDocument (kind, name); });
}

juce::String Presets::loadedName (LibraryKind kind) const
{
    const auto& name =
        kind == LibraryKind::device ? processor.device()->description.name : processor.focus()->description.name;
    const auto shown = name.empty() ? juce::String ("unnamed") : juce::String::fromUTF8 (name.c_str());
    const auto isWritten = kind == LibraryKind::focus && processor.session().snapshot()->isAsWritten;
    return isWritten ? shown + " (as written)" : shown;
}
} // namespace antinode
