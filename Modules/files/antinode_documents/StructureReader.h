#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** A device of kind "beam". @throws InputError [worker] */
BeamDescription readBeam (const JsonValue& device);

/** A device of kind "staple". @throws InputError [worker] */
StapleDescription readStaple (const JsonValue& device);

/** A device of kind "plate": rectangular, with ceramics along its axes and edges that are held or free, or of any
   outline and held in any way. @throws InputError [worker] */
std::variant<PlateDescription, OutlinedPlate> readPlate (const JsonValue& device);
} // namespace antinode
