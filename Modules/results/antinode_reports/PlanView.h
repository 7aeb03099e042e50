#pragma once

#include "HeatMap.h"

namespace antinode
{
/** A surface from above: where things lie on it. */
struct PlanView
{
    std::string title, xLabel,
        yLabel;             ///< Labels include the unit. Without a y label the y direction has no scale: a beam.
    AxisRange x, y;         ///< The surface.
    MapShape surface;       ///< Its outline where it does not fill the ranges; empty: it does.
    MapShape heldPieces;    ///< Open lines: the parts of the outline drawn hatched.
    MapShape elasticPieces; ///< The same, drawn as zigzags.
    std::vector<MapRectangle> rectangles;
    std::vector<MapPoint> points;
    bool heldLeft = false, heldRight = false, heldBottom = false, heldTop = false; ///< Edges drawn hatched.
};
} // namespace antinode
