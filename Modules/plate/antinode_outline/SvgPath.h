#pragma once

#include "Drawing.h"

#include <Eigen/Geometry>

#include <optional>
#include <string_view>
#include <vector>

namespace antinode
{
/** Reads numbers as SVG writes them: parted by blanks, commas, or nothing where a sign or a second point says it. */
class SvgNumbers
{
public:
    explicit SvgNumbers (std::string_view text) : rest (text) {}

    /** The next one; nothing where no finite number stands there. */
    std::optional<double> number();

    /** The next flag of an arc, 0 or 1, which needs nothing behind it. */
    std::optional<bool> flag();

    /** The next letter, taken; 0 where a number or nothing is next. */
    char letter();

    /** Whether nothing is left but blanks. */
    bool isAtEnd();

    /** What is left. */
    std::string_view left() const { return rest; }

private:
    void skipBlanks (bool andComma);

    std::string_view rest;
};

/** All numbers of a list; nothing where something else stands in it. [any] */
std::optional<std::vector<double>> svgNumberList (std::string_view);

/** A list of transforms, as of the attribute of that name; nothing where it is not one. [any]
   https://www.w3.org/TR/SVG11/coords.html#TransformAttribute */
std::optional<Eigen::Affine2d> svgTransform (std::string_view);

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
