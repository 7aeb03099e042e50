#pragma once

#include "Outline.h"

#include <optional>

namespace antinode
{
/** Two paths that cross or touch, which may be one and the same. */
struct PathConflict
{
    std::size_t path = 0, other = 0; ///< The smaller index first.
    Eigen::Vector2d place;           ///< m
};

/** How closed paths lie to each other. */
struct PathNesting
{
    std::optional<PathConflict> conflict;
    std::vector<std::optional<std::size_t>> around; ///< The innermost path around each, where there is no conflict.
};

/** Finds whether paths cross or touch, and else which lies in which, in a time that grows little faster than the number
   of their pieces.
    @param tolerance  m: what is nearer than that touches
    [any] Shamos and Hoey, Geometric intersection problems, 1976: the pieces that a line of equal x crosses, in order.
 */
PathNesting nestingOf (const std::vector<ClosedPath>&, double tolerance);

/** A place at which two pieces come nearer to each other than a tolerance; nothing where they do not. Of pieces that
   share an end, what lies near it does not count, unless they run back along each other from there. [any] */
std::optional<Eigen::Vector2d> meeting (const PathPiece&, const PathPiece&, double tolerance);
} // namespace antinode
