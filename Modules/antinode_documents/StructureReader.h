#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** A device of kind "beam". @throws InputError [worker] */
BeamDescription readBeam (const JsonValue& device);

/** A device of kind "staple". @throws InputError [worker] */
StapleDescription readStaple (const JsonValue& device);

/** A device of kind "plate". @throws InputError [worker] */
PlateDescription readPlate (const JsonValue& device);
} // namespace antinode
