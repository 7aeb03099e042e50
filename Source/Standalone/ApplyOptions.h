#pragma once

#include "StandaloneHost.h"
#include "StandaloneOptions.h"

namespace antinode
{
/** The settings with what the options say in place of what they keep: device, rate, ports. [any] */
StandaloneSettings withOptions (StandaloneSettings, const StandaloneOptions&);

/** The file that the options mean. [any] */
SettingsFile chooseSettingsFile (const StandaloneOptions&);

/** Loads the focus and the instrument of the options, and opens the graph where they ask for it.
    @throws InputError  where one cannot be read [message thread] */
void loadDocuments (StandaloneHost&, const StandaloneOptions&);

/** The notes of the options and of their MIDI file.
    @throws InputError  where one is none, or the file is none [worker] */
std::vector<TimedNote> readNotes (const StandaloneOptions&);
} // namespace antinode
