#pragma once

#include "HeatMap.h"

namespace antinode
{
/** A surface from above: where things lie on it. */
struct PlanView
{
    std::string title, xLabel,
        yLabel;     ///< Labels include the unit. Without a y label the y direction has no scale: a beam.
    AxisRange x, y; ///< The surface.
    std::vector<MapRectangle> rectangles;
    std::vector<MapPoint> points;
    bool heldLeft = false, heldRight = false, heldBottom = false, heldTop = false; ///< Edges drawn hatched.
};
} // namespace antinode
