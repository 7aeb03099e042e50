#pragma once

#include "Drawing.h"
#include "XmlTree.h"

#include <Eigen/Geometry>

namespace antinode
{
/** From the coordinates of an SVG's root, in which y points downwards, to m from the lower left corner of its page.
    @param unit  m of one unit of the drawing; 0: what width, height and viewBox say
    @throws InputError  where they do not say it
    [any] */
Eigen::Affine2d svgPage (const XmlNode& root, double unit, const std::string& source);

/** All that an SVG drawing shows of the chosen layer, group or element, in m, y upwards from the lower left corner of
   its page.
    @throws InputError  source, which element, what is wrong
    [worker] https://www.w3.org/TR/SVG11 */
std::vector<Stroke> svgStrokes (std::string_view bytes, const std::string& source, const DrawingChoice&);
} // namespace antinode
