#include "Surface.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_outline/PathBuilder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

SquareCells squareCells (const Surface& surface, int about)
{
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto isLine = surface.kind == SurfaceKind::line;
    SquareCells cells;
    cells.columns = isLine ? about : std::max (1L, std::lround (std::sqrt (about * width / height)));
    cells.rows = isLine ? 1 : std::max (1L, std::lround (about / static_cast<double> (cells.columns)));
    cells.centres.resize (cells.columns * cells.rows, 2);

    for (Eigen::Index j = 0; j < cells.rows; ++j)
        for (Eigen::Index i = 0; i < cells.columns; ++i)
        {
            const auto x = (static_cast<double> (i) + 0.5) / static_cast<double> (cells.columns);
            const auto y = (static_cast<double> (j) + 0.5) / static_cast<double> (cells.rows);
            cells.centres.row (j * cells.columns + i) << std::lerp (surface.xMinimum, surface.xMaximum, x),
                std::lerp (surface.yMinimum, surface.yMaximum, y);
        }

    return cells;
}
} // namespace antinode
