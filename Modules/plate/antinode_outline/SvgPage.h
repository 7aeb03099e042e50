#pragma once

#include "XmlTree.h"

#include <Eigen/Geometry>

namespace antinode
{
/** From the coordinates of an SVG's root, in which y points downwards, to m from the lower left corner of its page.
    @param unit  m of one unit of the drawing; 0: what width, height and viewBox say
    @throws InputError  where they do not say it
    [any] */
Eigen::Affine2d svgPage (const XmlNode& root, double unit, const std::string& source);
} // namespace antinode
