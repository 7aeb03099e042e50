#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

#include <string>
#include <vector>

namespace antinode
{
/** A device of kind "beam". @throws InputError [worker] */
BeamDescription readBeam (const JsonValue& device);

/** A device of kind "staple". @throws InputError [worker] */
StapleDescription readStaple (const JsonValue& device);

/** A device of kind "plate": rectangular, with ceramics along its axes and edges that are held or free, or of any
   outline and held in any way. @throws InputError [worker] */
std::variant<PlateDescription, OutlinedPlate> readPlate (const JsonValue& device);

/** How an edge of a plate is held: a word, or an object with springs along it. @throws InputError [worker] */
PlateEdge readPlateEdge (const JsonValue&);

/** How the edges of an outlined plate are held: all in one way, or by their names, with "others" for the rest; parts of
   them that "parts" gives become edges of their own.
    @param names  of the outline's edges
    @throws InputError [worker] */
void readPlateEdges (const JsonValue&, const std::vector<std::string>& names, OutlinedPlate&);

/** What else holds or loads a plate: its entries "foundation", "areas" and "points". @throws InputError [worker] */
void readSupports (const JsonObject& device, OutlinedPlate&);
} // namespace antinode
