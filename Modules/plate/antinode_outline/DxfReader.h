#pragma once

#include "Drawing.h"

namespace antinode
{
/** All that the model space of a DXF drawing shows of the chosen layer, or of all layers that are on, in m.
    @throws InputError  source, which entity, what is wrong
    [worker] AutoCAD 2012 DXF Reference. */
std::vector<Stroke> dxfStrokes (std::string_view bytes, const std::string& source, const DrawingChoice&);
} // namespace antinode
