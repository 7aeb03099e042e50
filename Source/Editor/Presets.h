#pragma once

#include "History.h"

#include <antinode_library/Library.h>

#include <string>

namespace antinode
{
/** What can be done with the devices and focuses of the library. Each gives one sentence where it could not be done; then nothing has
    changed. [message thread] */
class Presets
{
public:
    Presets (AntinodeProcessor&, History&);

    /** @param nameOrFile  as loadDocument */
    juce::String load (LibraryKind, const std::string& nameOrFile);

    /** Keeps the device, or the focus as the parameters changed it, as the user's own, and goes on with that. */
    juce::String save (LibraryKind, const std::string& name);

    /** Removes one of the user's own. */
    juce::String remove (LibraryKind, const std::string& name);

    /** The name of what is loaded. */
    juce::String loadedName (LibraryKind) const;

private:
    AntinodeProcessor& processor;
    History& history;
};
} // namespace antinode
