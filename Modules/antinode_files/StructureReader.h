#pragma once

#include "JsonReader.h"

#include <antinode_structure/DeviceDescription.h>

namespace antinode
{
/** A device of kind "beam". @throws InputError [worker] */
BeamDescription readBeam (const JsonValue& device);

/** A device of kind "staple". @throws InputError [worker] */
StapleDescription readStaple (const JsonValue& device);

/** A device of kind "plate". @throws InputError [worker] */
PlateDescription readPlate (const JsonValue& device);
} // namespace antinode
