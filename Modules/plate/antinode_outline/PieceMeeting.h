#pragma once

#include "PathPiece.h"

namespace antinode
{
/** A place at which two pieces come nearer to each other than a tolerance; nothing where they do not. Of pieces that
   share an end, what lies near it does not count, unless they run back along each other from there. [any] */
std::optional<Eigen::Vector2d> meeting (const PathPiece&, const PathPiece&, double tolerance);
} // namespace antinode
