#include "SurfaceCells.h"

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
    const Polygon rectangle { lower, { upper.x(), lower.y() }, upper, { lower.x(), upper.y() } };
    Eigen::VectorXd result (points.rows());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        const Eigen::Vector2d here = points.row (p);
        auto cell = rectangle;

        for (Eigen::Index q = 0; q < points.rows() && ! cell.empty(); ++q)
            if (const Eigen::Vector2d there = points.row (q); q != p)
                cell = clipped (cell, (here + there) / 2, there - here);

        result[p] = polygonArea (cell);
    }

    return result;
}
} // namespace antinode
