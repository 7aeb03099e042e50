#pragma once

#include "BendingProblem.h"

namespace antinode
{
// Patches of the usual shapes, with the kinks that their edges make, and nothing on them yet. Lengths in m, angles in
// rad counter-clockwise. [any] Docs/Theory.md, section 1.13.

BendingPatch rectanglePatch (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle);

BendingPatch discPatch (const Eigen::Vector2d& centre, double radius);

BendingPatch ringPatch (const Eigen::Vector2d& centre, double radius, double innerRadius);
} // namespace antinode
