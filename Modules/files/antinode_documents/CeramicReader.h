#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

#include <optional>
#include <vector>

namespace antinode
{
/** The ceramics of a beam or a staple's top: by their centre, from the middle. They may touch, not overlap or leave it.
    @param length, width  of the beam, mm
    @throws InputError  with the place of the ceramic [worker] */
std::vector<CeramicDescription> readCentredCeramics (const JsonValue& list, double length, double width);

/** The ceramics of a plate: rectangles by their lower left corner or their middle, turned or not, discs and rings.
   Rectangles along the axes may touch, not overlap or leave a rectangular plate; whether others do is for the solver.
    @param size  of a rectangular plate, mm
    @throws InputError  with the place of the ceramic [worker] */
std::vector<CeramicDescription> readPlateCeramics (const JsonValue& list, const std::optional<Eigen::Vector2d>& size);
} // namespace antinode
