#pragma once

#include "History.h"

#include <antinode_documents/Library.h>

#include <string>

namespace antinode
{
/** Actions on the devices and focuses of the library. Each returns one sentence if it failed; then nothing has
    changed. [message thread] */
class Presets
{
public:
    Presets (AntinodeProcessor&, History&);

    /** @param nameOrFile  as loadDocument; as a focus a written design too, where it fits the loaded device */
    juce::String load (LibraryKind, const std::string& nameOrFile);

    /** A device, a focus or a written design, as its file says. */
    juce::String loadFile (const std::string& file);

    /** Saves the device, or the focus with its parameter changes, as a user preset, and continues with that. */
    juce::String save (LibraryKind, const std::string& name);

    /** Removes a user preset. */
    juce::String remove (LibraryKind, const std::string& name);

    /** The name of the loaded preset. */
    juce::String loadedName (LibraryKind) const;

private:
    AntinodeProcessor& processor;
    History& history;
};
} // namespace antinode
