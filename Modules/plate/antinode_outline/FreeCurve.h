#pragma once

#include "PathBuilder.h"

#include <array>
#include <functional>

namespace antinode
{
/** A smooth curve by a parameter. */
struct FreeCurve
{
    std::function<Eigen::Vector2d (double)> at;    ///< m
    std::function<Eigen::Vector2d (double)> slope; ///< Its derivative; it may vanish at ends.
};

/** Draws a curve as arcs and lines that leave the path smooth: pairs of arcs with the curve's tangents, halved until
   they lie within a deviation. The path is at the curve's start. [worker] K. M. Bolton, Biarc curves, Computer-Aided
   Design 7 (1975). */
void drawCurve (PathBuilder&, const FreeCurve&, double from, double to, double deviation, int edge);

/** Draws Bezier's cubic curve through four control points, the first of which is where the path is: as one arc of an
   ellipse where it is what programs write for one, else as drawCurve(). [worker] */
void drawBezier (PathBuilder&, const std::array<Eigen::Vector2d, 4>& points, double deviation, int edge);
} // namespace antinode
