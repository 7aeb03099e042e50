#pragma once

#include "Outline.h"

#include <optional>

namespace antinode
{
/** An outline of which the part from one place of a path to another, counter-clockwise, is an edge of its own. The
   places are those of the boundary that are nearest to the given ones.
    @return  nothing where the two lie on different paths
    [any] */
std::optional<Outline> withEdgeAlong (Outline, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int edge);

/** The largest number of an edge. [any] */
int lastEdge (const Outline&);
} // namespace antinode
