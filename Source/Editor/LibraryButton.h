#pragma once

#include <antinode_documents/Library.h>

#include <juce_gui_basics/juce_gui_basics.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <string>

namespace antinode
{
/** A button with the name of something that is loaded; a click chooses another one of the library, or of a file, or
    nothing. [message thread] */
class LibraryButton final : public juce::TextButton
{
public:
    using Take = std::function<void (const nlohmann::json&, const std::string& source)>;

    /** @param what         is loaded: "device"
        @param take         gets what was chosen; an InputError of it becomes error()
        @param takeNothing  called where nothing was chosen; none: it cannot be */
    LibraryButton (LibraryKind, const juce::String& what, Take take, std::function<void()> takeNothing = {});

    /** Loads one of the library, or of a file. */
    void loadDocument (const std::string& nameOrFile);

    /** What is wrong with the one that was chosen last, in one sentence; empty where nothing is. */
    juce::String error() const { return said; }

private:
    void choose();
    void chooseFile();

    LibraryKind kind;
    juce::String what;
    Take onTake;
    std::function<void()> onNothing;
    std::unique_ptr<juce::FileChooser> chooser;
    juce::String said;
};
} // namespace antinode
