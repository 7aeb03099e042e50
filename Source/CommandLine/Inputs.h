#pragma once

#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** The names of the embedded files of a folder, "Devices" or "Focuses", sorted. [any] */
std::vector<std::string> embeddedNames (const std::string& folder);

/** The embedded JSON of a name, or a file's. A name with a '/' or ending in ".json" is a file.
    @param folder  "Devices" or "Focuses"
    @throws InputError  when there is no such name (with those there are) or the file cannot be read
    [worker] */
nlohmann::json loadDocument (const std::string& folder, const std::string& nameOrFile);

/** A device's JSON with the assignments that begin with "device." applied. [worker] */
nlohmann::json loadDeviceDocument (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** A device by embedded name or file, with the assignments that begin with "device." applied.
    @throws InputError  as loadDocument and readDevice. [worker] */
DeviceDescription loadDevice (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** A focus by embedded name or file, with the assignments that begin with "focus." applied. [worker] */
FocusDescription loadFocus (const std::string& nameOrFile, const std::vector<std::string>& assignments);

/** The modal model of a device, with modes from the user's cache where they are there.
    @param usesCache  false: solved in any case, and not kept
    @throws InputError  as solveStructure. [worker] */
ModalModel solveDevice (const DeviceDescription&, std::optional<int> modeCount, bool usesCache);

/** @throws InputError  when an assignment begins with neither "device." nor "focus.". [any] */
void checkAssignments (const std::vector<std::string>& assignments);
} // namespace antinode
