#pragma once

#include "Surface.h"

namespace antinode
{
/** The extent of a surface in a grid of cells that are about square, row by row from below. */
struct SquareCells
{
    Eigen::Index columns = 0, rows = 0; ///< One row on a line.
    Eigen::MatrixX2d centres;           ///< columns * rows x 2: x and y, m; outside the boundary, too.
};

/** @param about  how many cells, roughly on a plate, exactly on a line; at least 1
    [any] */
SquareCells squareCells (const Surface&, int about);
} // namespace antinode
