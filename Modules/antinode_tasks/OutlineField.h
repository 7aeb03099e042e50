#pragma once

#include "Field.h"

#include <antinode_model/Surface.h>

#include <optional>
#include <string>

namespace antinode
{
/** Where the surface of a modal device ends. [any] */
Field outlineField (std::filesystem::path& outline);

/** Whether it is a drawing (.svg, .dxf), not a device. [any] */
bool isDrawingFile (const std::filesystem::path& outline);

/** The boundary that is named: that of a plate, or a drawing, of which no edge is held; none where it is empty.
    @throws InputError  where it cannot be read or has none [worker] */
std::optional<SurfaceBoundary> boundaryFrom (const std::filesystem::path& outline);
} // namespace antinode
