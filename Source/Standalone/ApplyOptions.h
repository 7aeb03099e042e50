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
} // namespace antinode
