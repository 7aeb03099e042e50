#pragma once

#include "BendingModes.h"
#include "CellSizes.h"

namespace antinode
{
/** Where along either axis cells are smaller than elsewhere. */
struct SmallCellsOfAxes
{
    std::vector<SmallCells> alongX, alongY;
};

/** Of what a plate has: re-entrant corners, at which moments are unbounded; arcs and holes with small radii; points
   with springs or masses; the edges of patches that bend the plate. [worker] Docs/Theory.md, section 1.13. */
SmallCellsOfAxes smallCells (const BendingProblem&, const ImmersedResolution&);
} // namespace antinode
