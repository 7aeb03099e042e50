#include "BoundedSurface.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_outline/OutlineShapes.h>

#include <algorithm>
#include <array>
#include <utility>

namespace antinode
{
Surface boundedBy (Surface surface, SurfaceBoundary boundary)
{
    constexpr double tolerance = 1e-3; // of the extent: measured places are rarely better

    if (surface.kind == SurfaceKind::line)
        throw InputError ("outline", "is given, but all points have the same y, which is a line; allowed for plates");

    const auto& outline = boundary.outline;
    const auto [least, largest] = extentOf (outline);
    const auto near = tolerance * (largest - least).maxCoeff();

    for (const auto& point : surface.points.rowwise())
        if (! outline.contains (point[0], point[1]) && distanceToBoundary (outline, point[0], point[1]) > near)
            throw InputError ("outline", "leaves out the point at (" + inWords (1000 * point[0]) + ", "
                                             + inWords (1000 * point[1]) + ") mm; allowed: one that holds all points");

    surface.xMinimum = std::min (surface.xMinimum, least.x());
    surface.yMinimum = std::min (surface.yMinimum, least.y());
    surface.xMaximum = std::max (surface.xMaximum, largest.x());
    surface.yMaximum = std::max (surface.yMaximum, largest.y());
    surface.boundary = std::move (boundary);
    return surface;
}

std::optional<SurfaceBoundary> boundaryOf (const Surface& surface)
{
    if (surface.boundary || surface.kind == SurfaceKind::line)
        return surface.boundary;

    const Eigen::Vector2d least (surface.xMinimum, surface.yMinimum), largest (surface.xMaximum, surface.yMaximum);
    const auto path = rectanglePath ((least + largest) / 2, largest - least, 0, {}, 1);
    const auto& held = surface.held;
    SurfaceBoundary boundary { { { path } }, {} };

    for (const auto& piece : path)
        if (std::array { held.bottom, held.right, held.top, held.left }[static_cast<std::size_t> (piece.edge - 1)])
            boundary.held.push_back (piece);

    return boundary;
}
} // namespace antinode
