#include "PatchShapes.h"

#include <antinode_outline/OutlineShapes.h>

#include <cmath>

namespace antinode
{
namespace
{
/** Vanishes on a circle with a slope of 1 across it. @param side  1: positive within it, -1: outside */
KinkFunction circleKink (const Eigen::Vector2d& centre, double radius, double side, double width, int edge)
{
    return { centre, Eigen::Vector2d::Zero(), side * radius / 2, -side / radius, edge, width };
}
} // namespace

BendingPatch rectanglePatch (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle)
{
    BendingPatch patch;
    patch.outline.paths = { rectanglePath (centre, size, angle, { 0, 0, 0, 0 }, 0) };

    for (const auto& piece : patch.outline.paths.front())
    {
        const Eigen::Vector2d inward = Eigen::Vector2d (-piece.cosine.y(), piece.cosine.x()).normalized();
        patch.kinks.push_back ({ piece.start, inward, 0, 0, piece.edge, inward.dot (centre - piece.start) });
    }

    return patch;
}

BendingPatch discPatch (const Eigen::Vector2d& centre, double radius)
{
    BendingPatch patch;
    patch.outline.paths = { circlePath (centre, radius, 0) };
    patch.kinks = { circleKink (centre, radius, 1, radius, 0) };
    return patch;
}

BendingPatch ringPatch (const Eigen::Vector2d& centre, double radius, double innerRadius)
{
    auto patch = discPatch (centre, radius);
    patch.outline.paths.push_back (circlePath (centre, innerRadius, 1));
    patch.kinks.push_back (circleKink (centre, innerRadius, -1, radius - innerRadius, 1));
    return patch;
}
} // namespace antinode
