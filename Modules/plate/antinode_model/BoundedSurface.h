#pragma once

#include "Surface.h"

namespace antinode
{
/** A plate of given points that ends at a boundary, to which it then extends.
    @throws InputError  where the points are a line, or one lies outside the boundary or in a hole by more than a
    thousandth of the extent [worker] */
Surface boundedBy (Surface, SurfaceBoundary);

/** Where a plate ends: its boundary, or the rectangle of its extent with the edges at which it is held. None of a line.
    [any] */
std::optional<SurfaceBoundary> boundaryOf (const Surface&);
} // namespace antinode
