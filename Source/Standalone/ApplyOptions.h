#pragma once

#include "StandaloneHost.h"
#include "StandaloneOptions.h"
#include "TouchHost.h"

namespace antinode
{
/** The settings with what the options say in place of what they keep: device, rate, inputs, ports.
    @throws InputError  as readFollowing [any] */
StandaloneSettings withOptions (StandaloneSettings, const StandaloneOptions&);

/** The file that the options mean. [any] */
SettingsFile chooseSettingsFile (const StandaloneOptions&);

/** Loads the focus and the instrument of the options, opens the graph and tracks where they ask for it.
    @throws InputError  where one cannot be read [message thread] */
void loadDocuments (StandaloneHost&, const StandaloneOptions&);

/** Loads the device of the options, and puts their fingers and inputs in place of those of the settings.
    @throws InputError  where the device cannot be read, or a finger or the inputs are none [message thread] */
void loadFingers (TouchHost&, const StandaloneOptions&);

/** A finger of an option: "X:Y" or "X:Y:LEVEL", mm and um.
    @throws InputError  where it is none [any] */
WantedFinger readFinger (const std::string&);

/** The notes of the options and of their MIDI file.
    @throws InputError  where one is none, or the file is none [worker] */
std::vector<TimedNote> readNotes (const StandaloneOptions&);
} // namespace antinode
