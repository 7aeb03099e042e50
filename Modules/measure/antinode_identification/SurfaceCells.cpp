#include "SurfaceCells.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace antinode
{
namespace
{
using Polygon = std::vector<Eigen::Vector2d>;

/** The part of a convex polygon where normal . (x - origin) <= 0. */
Polygon clipped (const Polygon& polygon, const Eigen::Vector2d& origin, const Eigen::Vector2d& normal)
{
    Polygon result;

    for (std::size_t n = 0; n < polygon.size(); ++n)
    {
        const auto& from = polygon[n];
        const auto& to = polygon[(n + 1) % polygon.size()];
        const auto heightFrom = normal.dot (from - origin), heightTo = normal.dot (to - origin);

        if (heightFrom <= 0)
            result.push_back (from);

        if ((heightFrom < 0 && heightTo > 0) || (heightFrom > 0 && heightTo < 0))
            result.push_back (from + heightFrom / (heightFrom - heightTo) * (to - from));
    }

    return result;
}

double polygonArea (const Polygon& polygon)
{
    double twice = 0;

    for (std::size_t n = 0; n < polygon.size(); ++n)
    {
        const auto& from = polygon[n];
        const auto& to = polygon[(n + 1) % polygon.size()];
        twice += from.x() * to.y() - from.y() * to.x();
    }

    return twice / 2;
}
/** The Voronoi cell of a point within a rectangle, counter-clockwise. */
Polygon cellOf (const Eigen::MatrixX2d& points, Eigen::Index p, const Eigen::Vector2d& lower,
                const Eigen::Vector2d& upper)
{
    Polygon cell { lower, { upper.x(), lower.y() }, upper, { lower.x(), upper.y() } };
    const Eigen::Vector2d here = points.row (p);

    for (Eigen::Index q = 0; q < points.rows() && ! cell.empty(); ++q)
        if (const Eigen::Vector2d there = points.row (q); q != p)
            cell = clipped (cell, (here + there) / 2, there - here);

    return cell;
}

Polygon asPolygon (const ClosedPath& path)
{
    constexpr int chords = 16;
    Polygon polygon;

    for (const auto& piece : path)
        for (int i = 0; i < (piece.isStraight ? 1 : chords); ++i)
            polygon.push_back (piece.at (piece.from + (piece.to - piece.from) * i / chords));

    return polygon;
}

/** What a convex cell, counter-clockwise, has of any polygon. */
double areaWithin (Polygon polygon, const Polygon& cell)
{
    for (std::size_t n = 0; n < cell.size(); ++n)
    {
        const Eigen::Vector2d along = cell[(n + 1) % cell.size()] - cell[n];
        polygon = clipped (polygon, cell[n], { along.y(), -along.x() });
    }

    return cell.empty() ? 0 : std::abs (polygonArea (polygon));
}
} // namespace

Eigen::VectorXd lineCells (const Eigen::VectorXd& x)
{
    const auto points = x.size();
    Eigen::VectorXd result = Eigen::VectorXd::Zero (points);

    if (points == 1)
        return Eigen::VectorXd::Ones (1);

    for (Eigen::Index p = 0; p + 1 < points; ++p)
    {
        const auto half = (x[p + 1] - x[p]) / 2;
        result[p] += half;
        result[p + 1] += half;
    }

    return result;
}

Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points)
{
    const Eigen::Vector2d lower = points.colwise().minCoeff(), upper = points.colwise().maxCoeff();
    Eigen::VectorXd result (points.rows());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        result[p] = polygonArea (cellOf (points, p, lower, upper));

    return result;
}

Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points, const Outline& outline)
{
    const auto extent = extentOf (outline);
    const Eigen::Vector2d lower = extent.least.cwiseMin (points.colwise().minCoeff().transpose());
    const Eigen::Vector2d upper = extent.largest.cwiseMax (points.colwise().maxCoeff().transpose());
    std::vector<Polygon> paths;

    for (const auto& path : outline.paths)
        paths.push_back (asPolygon (path));

    Eigen::VectorXd result (points.rows());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        const auto cell = cellOf (points, p, lower, upper);
        result[p] = areaWithin (paths.front(), cell);

        for (std::size_t hole = 1; hole < paths.size(); ++hole)
            result[p] -= areaWithin (paths[hole], cell);

        result[p] = std::max (result[p], 0.0); // rounding
    }

    return result;
}
} // namespace antinode
