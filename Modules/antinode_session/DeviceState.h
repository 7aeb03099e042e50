#pragma once

#include "Documents.h"
#include "FollowingSettings.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace antinode
{
/** All that a host keeps of a plug-in that has a device and parameters: the whole device, never only a path. */
struct DeviceState
{
    std::shared_ptr<const DeviceDocument> device;
    std::map<std::string, double> parameters;        ///< By their identifiers, in the units of their texts.
    std::shared_ptr<const FocusDocument> focus = {}; ///< Of Antinode Touch only; none: notes play nothing.
    FollowingSettings following = {};                ///< Of Antinode Touch only.
};

inline constexpr auto plateSchema = "antinode.plate/1"; ///< Of Antinode Plate.
inline constexpr auto touchSchema = "antinode.touch/1"; ///< Of Antinode Touch.

/** A state as text: JSON; numbers come back to the bit. [worker] Docs/FileFormats.md */
std::string deviceStateToText (const DeviceState&, const char* schema);

/** @throws InputError  "state: ...", where the text is no state, or one of a schema that was not asked for [worker] */
DeviceState readDeviceState (std::string_view text, const char* schema);
} // namespace antinode
