#pragma once

#include "Library.h"

#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>

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

/** @throws InputError  when an assignment begins with neither "device." nor "focus.". [any] */
void checkAssignments (const std::vector<std::string>& assignments);
} // namespace antinode
