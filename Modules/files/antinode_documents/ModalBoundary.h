#pragma once

#include <antinode_model/Surface.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
// The boundary of a modal device: "outline", as of a plate, and "held_edges", those of its edges that cannot move.
// Docs/FileFormats.md.

/** Puts the boundary of a file on a surface of given points, which then extends to it; without one nothing.
    @throws InputError  as readOutline, and where a point lies outside it [worker] */
void readBoundary (const JsonObject& device, Surface&);

/** Writes what readBoundary() understands. A hole of which a part is held counts as held. [worker] */
void boundaryToJson (nlohmann::ordered_json& device, const SurfaceBoundary&);
} // namespace antinode
