#pragma once

#include "Library.h"

#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_tracks/Waveforms.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** A device's JSON with the assignments that begin with "device." applied. [worker] */
nlohmann::json loadDeviceDocument (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** A device by embedded name or file, with the assignments that begin with "device." applied.
    @throws InputError  as loadDocument and readDevice. [worker] */
DeviceDescription loadDevice (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** A focus by embedded name or file, with the assignments that begin with "focus." applied. [worker] */
FocusDescription loadFocus (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** A focus from its document, with the built-in threshold of skin where it asks for one.
    @param source        how errors name it
    @param fallbackName  its name where the document has none
    @throws InputError   as readFocus. [worker] */
FocusDescription focusFromDocument (const nlohmann::json&, const std::string& source, const std::string& fallbackName);

/** Waveforms at touched points by embedded name or file, with the assignments that begin with "waveforms." applied.
    Recordings and haptic content are looked for beside the file, which may itself be haptic content
   (waveformsDocument).
    @throws InputError  as loadDocument and readWaveforms. [worker] */
WaveformsDescription loadWaveforms (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** Waveforms from their document. @param file  beside which recordings are looked for, and whose stem is the name of
    waveforms that have none
    @throws InputError  as readWaveforms. [worker] */
WaveformsDescription waveformsFromDocument (const nlohmann::json&, const std::string& source, const std::string& file);

/** The device that a focus or waveforms name, as loadDevice takes it: a file's name begins at the folder of theirs.
    @return  empty: none is named
    @throws InputError  as loadDocument and readNamedDevice
    [worker] */
std::string namedDevice (LibraryKind, const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** @throws InputError  when an assignment begins with none of "device.", "focus." and "waveforms.". [any] */
void checkAssignments (const std::vector<std::string>& assignments);
} // namespace antinode
