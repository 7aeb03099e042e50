#pragma once

#include "Documents.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace antinode
{
/** All that a host keeps of a surface: the whole device, never only a path. */
struct PlateState
{
    std::shared_ptr<const DeviceDocument> device;
    std::map<std::string, double> parameters; ///< By their identifiers, in the units of their texts.
};

/** A state as text: JSON of schema antinode.plate/1; numbers come back to the bit. [worker] Docs/FileFormats.md */
std::string plateStateToText (const PlateState&);

/** @throws InputError  "state: ...", where the text is no state, or one of a version that this program does not know
    [worker] */
PlateState readPlateState (std::string_view text);
} // namespace antinode
