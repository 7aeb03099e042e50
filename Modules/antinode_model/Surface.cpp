#include "Surface.h"

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

std::vector<Eigen::Index> pointsOn (const Surface& surface)
{
    std::vector<Eigen::Index> rows;

    for (Eigen::Index i = 0; i < surface.areas.size(); ++i)
        if (surface.areas[i] > 0)
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
