#include "Surface.h"

namespace antinode
{
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
