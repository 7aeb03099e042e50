#pragma once

#include <antinode_numerics/SplineAxis.h>

#include <vector>

namespace antinode
{
/** A place along an axis near which cells are small. */
struct SmallCells
{
    double place = 0;
    double cell = 0;      ///< The size of cells at the place.
    double growth = 1;    ///< Cells may be larger by this times the distance from it.
    int multiplicity = 0; ///< Of the knot there: 0 if there need not be a break; more than 1 lets derivatives jump.
};

/** Breaks from a place to another one, at most a cell apart and closer where that is wanted: evenly spaced by the
   integral of 1 / size. [worker] */
SplineBreaks breaksBetween (double from, double to, double cell, const std::vector<SmallCells>&);
} // namespace antinode
