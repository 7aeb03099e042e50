#include "FieldSampling.h"

#include <antinode_base/Watch.h>
#include <antinode_model/ShapeInterpolation.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int maximumScatteredCells = 64;

/** The middles of equal cells. */
Eigen::VectorXd middles (double minimum, double maximum, Eigen::Index cells)
{
    const auto half = 0.5 * (maximum - minimum) / static_cast<double> (cells);
    return Eigen::VectorXd::LinSpaced (cells, minimum + half, maximum - half);
}

std::vector<Eigen::MatrixXd> mapsOfGrid (const PlateGrid& grid, const Eigen::MatrixXd& fields, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& y)
{
    const auto rowsX = interpolationRows (grid.x, x), rowsY = interpolationRows (grid.y, y);
    std::vector<Eigen::MatrixXd> maps;

    for (const auto& field : fields.colwise())
    {
        checkWatch();
        const Eigen::VectorXd values = field;
        const Eigen::Map<const Eigen::MatrixXd> onGrid (values.data(), rowsX.cols(), rowsY.cols());
        maps.emplace_back (rowsY * (rowsX * onGrid).transpose());
    }

    return maps;
}

/** Fields at places, wherever these lie. */
Eigen::MatrixXd valuesAt (const Surface& surface, const Eigen::MatrixXd& fields, const Eigen::MatrixX2d& places)
{
    Eigen::MatrixXd values (places.rows(), fields.cols());

    for (Eigen::Index i = 0; i < places.rows(); ++i)
    {
        checkWatch();
        values.row (i) = surface.grid ? interpolateOnGrid (*surface.grid, fields, places (i, 0), places (i, 1))
                                      : interpolateInPlane (surface.points, fields, places (i, 0), places (i, 1));
    }

    return values;
}

std::vector<Eigen::MatrixXd> mapsOfPoints (const Surface& surface, const Eigen::MatrixXd& fields,
                                           const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    Eigen::MatrixX2d places (x.size() * y.size(), 2);
    places.col (0) = x.replicate (y.size(), 1);
    places.col (1) = y.transpose().replicate (x.size(), 1).reshaped();
    const auto values = valuesAt (surface, fields, places);
    std::vector<Eigen::MatrixXd> maps;

    for (const auto& map : values.colwise())
        maps.emplace_back (map.reshaped (x.size(), y.size()).transpose());

    return maps;
}

/** Beyond a boundary maps get the values of its nearest places, so that nothing shows where they are cut off there. */
void continueBeyond (std::vector<Eigen::MatrixXd>& maps, const Surface& surface, const Eigen::MatrixXd& fields,
                     const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    std::vector<Eigen::Vector2i> cells;
    std::vector<Eigen::Vector2d> nearest;

    for (Eigen::Index j = 0; j < y.size(); ++j)
        for (Eigen::Index i = 0; i < x.size(); ++i)
            if (! surface.boundary->outline.contains (x[i], y[j]))
            {
                cells.emplace_back (static_cast<int> (j), static_cast<int> (i));
                nearest.push_back (nearestOn (surface, x[i], y[j]));
            }

    Eigen::MatrixX2d places (static_cast<Eigen::Index> (nearest.size()), 2);

    for (std::size_t p = 0; p < nearest.size(); ++p)
        places.row (static_cast<Eigen::Index> (p)) = nearest[p].transpose();

    const auto values = valuesAt (surface, fields, places);

    for (std::size_t p = 0; p < cells.size(); ++p)
        for (std::size_t k = 0; k < maps.size(); ++k)
            maps[k](cells[p][0], cells[p][1]) = values (static_cast<Eigen::Index> (p), static_cast<Eigen::Index> (k));
}
} // namespace

Eigen::MatrixXd fieldsAt (const Surface& surface, const Eigen::MatrixXd& fields, const Eigen::MatrixX2d& places)
{
    auto values = valuesAt (surface, fields, places);

    for (Eigen::Index i = 0; surface.boundary && i < places.rows(); ++i)
        if (! liesOn (surface, places (i, 0), places (i, 1)))
            values.row (i).setConstant (std::nan (""));

    return values;
}

std::vector<Eigen::MatrixXd> fieldMaps (const Surface& surface, const Eigen::MatrixXd& fields, int maximumCells)
{
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto cells = surface.grid ? maximumCells : std::min (maximumCells, maximumScatteredCells);
    const auto along = [&] (double length)
    { return std::max<Eigen::Index> (1, std::lround (cells * length / std::max (width, height))); };
    const auto x = middles (surface.xMinimum, surface.xMaximum, along (width));
    const auto y = middles (surface.yMinimum, surface.yMaximum, along (height));
    auto maps = surface.grid ? mapsOfGrid (*surface.grid, fields, x, y) : mapsOfPoints (surface, fields, x, y);

    if (surface.boundary)
        continueBeyond (maps, surface, fields, x, y);

    return maps;
}
} // namespace antinode
