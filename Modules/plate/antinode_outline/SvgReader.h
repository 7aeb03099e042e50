#pragma once

#include "Drawing.h"
#include "Stroke.h"

namespace antinode
{
/** All that an SVG drawing shows of the chosen layer, group or element, in m, y upwards from the lower left corner of
   its page.
    @throws InputError  source, which element, what is wrong
    [worker] https://www.w3.org/TR/SVG11 */
std::vector<Stroke> svgStrokes (std::string_view bytes, const std::string& source, const DrawingChoice&);
} // namespace antinode
