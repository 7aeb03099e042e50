#pragma once

#include "Stroke.h"

#include <string_view>

namespace antinode
{
/** The strokes of a path's attribute d, one for each of its parts; a part that is closed ends where it begins.
    @param map  from the path's coordinates to m
    @param edge  the number of the next edge, counted on
    @throws InputError  with the name of the path
    [worker] https://www.w3.org/TR/SVG11/paths.html */
std::vector<Stroke> svgPathStrokes (std::string_view data, const Eigen::Affine2d& map, double deviation,
                                    const std::string& name, int& edge);

/** A part of an ellipse as SVG gives it, appended to a path that is at its start.
    @param radii, turn  of the ellipse before the map, the angle in degrees */
void drawSvgArc (PathBuilder&, const Eigen::Vector2d& start, const Eigen::Vector2d& end, Eigen::Vector2d radii,
                 double turn, bool isLarge, bool isPositive, const Eigen::Affine2d& map, int edge);
} // namespace antinode
