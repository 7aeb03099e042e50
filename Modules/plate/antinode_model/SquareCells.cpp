#include "SquareCells.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
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
