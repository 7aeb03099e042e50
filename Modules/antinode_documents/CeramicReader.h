#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

#include <vector>

namespace antinode
{
/** The ceramics of a beam or a staple's top: by their centre, from the middle. They may touch, not overlap or leave it.
    @param length, width  of the beam, mm
    @throws InputError  with the place of the ceramic [worker] */
std::vector<CeramicDescription> readCentredCeramics (const JsonValue& list, double length, double width);

/** The ceramics of a plate: by their lower left corner. They may touch, not overlap or leave it.
    @param lengthX, lengthY  of the plate, mm
    @throws InputError  with the place of the ceramic [worker] */
std::vector<CeramicDescription> readCornerCeramics (const JsonValue& list, double lengthX, double lengthY);
} // namespace antinode
