#include "Surface.h"

#include "PlaceOnSurface.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
bool liesOn (const Surface& surface, double x, double y)
{
    const auto margin = 1e-9 + 1e-9 * (surface.xMaximum - surface.xMinimum); // rounding, not geometry
    const auto isWithin =
        x >= surface.xMinimum - margin && x <= surface.xMaximum + margin
        && (surface.kind == SurfaceKind::line || (y >= surface.yMinimum - margin && y <= surface.yMaximum + margin));

    if (! isWithin || ! surface.boundary)
        return isWithin;

    const auto& outline = surface.boundary->outline;
    return outline.contains (x, y) || distanceToBoundary (outline, x, y) <= margin;
}

Eigen::Vector2d nearestOn (const Surface& surface, double x, double y)
{
    if (liesOn (surface, x, y) && surface.boundary)
        return { x, y };

    if (surface.boundary)
        return nearestOnBoundary (surface.boundary->outline, x, y);

    return { std::clamp (x, surface.xMinimum, surface.xMaximum), std::clamp (y, surface.yMinimum, surface.yMaximum) };
}

void requireWithinBoundary (const Surface& surface, double x, double y, const std::string& where)
{
    if (! surface.boundary || liesOn (surface, x, y))
        return;

    const Eigen::Vector2d nearest = 1000 * nearestOnBoundary (surface.boundary->outline, x, y);
    throw InputError (where, "(" + inWords (x * 1000) + ", " + inWords (y * 1000)
                                 + ") mm is outside the outline of the surface or in a hole; allowed: places on it, "
                                   "the nearest at ("
                                 + inWords (nearest.x()) + ", " + inWords (nearest.y()) + ") mm");
}

void requireOnLine (const Surface& surface, double y, const std::string& where)
{
    constexpr double rounding = 1e-9; // m

    if (surface.kind == SurfaceKind::line && ! (std::abs (y) <= rounding))
        throw InputError (where, "is " + inWords (y * 1000) + " mm, but the surface is a line; allowed: 0");
}

void requireOnSurface (const Surface& surface, double x, double y, const std::string& where)
{
    const auto check = [&] (const char* axis, double value, double least, double most)
    {
        if (! (value >= least && value <= most))
            throw InputError (where + axis, "is " + inWords (value * 1000)
                                                + " mm, which is outside the surface; allowed: "
                                                + inWords (least * 1000) + " to " + inWords (most * 1000) + " mm");
    };
    check (" x", x, surface.xMinimum, surface.xMaximum);

    if (surface.kind == SurfaceKind::plate)
        check (" y", y, surface.yMinimum, surface.yMaximum);

    requireOnLine (surface, y, where + " y");
    requireWithinBoundary (surface, x, y, where);
}

std::vector<Eigen::Index> pointsOn (const Surface& surface)
{
    std::vector<Eigen::Index> rows;

    for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
        if (! surface.boundary || surface.areas[i] > 0)
            rows.push_back (i);

    return rows;
}

void placeOnGrid (Surface& surface, const PlateGrid& grid)
{
    const auto countX = grid.x.places.size(), countY = grid.y.places.size();
    surface.kind = SurfaceKind::plate;
    surface.points.resize (countX * countY, 2);
    surface.areas.resize (countX * countY);
    surface.masses.resize (countX * countY);

    for (Eigen::Index j = 0; j < countY; ++j)
    {
        surface.points.col (0).segment (j * countX, countX) = grid.x.places;
        surface.points.col (1).segment (j * countX, countX).setConstant (grid.y.places[j]);
        surface.areas.segment (j * countX, countX) = grid.x.weights * grid.y.weights[j];
    }

    surface.xMinimum = grid.x.edges[0];
    surface.xMaximum = grid.x.edges[grid.x.edges.size() - 1];
    surface.yMinimum = grid.y.edges[0];
    surface.yMaximum = grid.y.edges[grid.y.edges.size() - 1];
    surface.grid = grid;
}
} // namespace antinode
