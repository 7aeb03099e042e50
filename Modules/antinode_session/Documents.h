#pragma once

#include <antinode_fingers/Finger.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** A device with the text that it was read from: a state keeps the text, the session solves the description. */
struct DeviceDocument
{
    std::string text; ///< JSON
    DeviceDescription description;
};

/** A focus with the text that it was read from. */
struct FocusDocument
{
    std::string text; ///< JSON
    FocusDescription description;
};

/** @param source  how errors name it
    @throws InputError  as readDevice [worker] */
DeviceDocument readDeviceDocument (const nlohmann::json&, const std::string& source);

/** @throws InputError  as readFocus [worker] */
FocusDocument readFocusDocument (const nlohmann::json&, const std::string& source);

/** A focus with other fingers, in its text too.
    @throws InputError  as readFocus: more than maximumFingers, or properties that no file may have [worker] */
FocusDocument withFingers (const FocusDocument&, const std::vector<Finger>&);
} // namespace antinode
