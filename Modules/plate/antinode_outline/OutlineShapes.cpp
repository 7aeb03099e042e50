#include "OutlineShapes.h"

#include "PathBuilder.h"

#include <cmath>
#include <numbers>

namespace antinode
{
ClosedPath rectanglePath (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle,
                          const std::array<double, 4>& radii, int firstEdge)
{
    const Eigen::Vector2d along = size.x() / 2 * Eigen::Vector2d (std::cos (angle), std::sin (angle));
    const Eigen::Vector2d across = size.y() / 2 * Eigen::Vector2d (-std::sin (angle), std::cos (angle));
    const std::array<Eigen::Vector2d, 4> corners { centre - along - across, centre + along - across,
                                                   centre + along + across, centre - along + across };
    const std::array<Eigen::Vector2d, 4> directions { along.normalized(), across.normalized(), -along.normalized(),
                                                      -across.normalized() };
    const auto bulge = std::tan (std::numbers::pi / 8); // Of a quarter of a circle.
    PathBuilder path (corners[0] - radii[0] * directions[3]);

    for (std::size_t i = 0; i < 4; ++i)
    {
        const auto next = (i + 1) % 4;
        const auto edge = firstEdge + static_cast<int> (i);
        path.arcTo (corners[i] + radii[i] * directions[i], bulge, edge);
        path.lineTo (corners[next] - radii[next] * directions[i], edge);
    }

    return path.close();
}

ClosedPath ellipsePath (const Eigen::Vector2d& centre, const Eigen::Vector2d& semiaxes, double angle, int edge)
{
    const Eigen::Vector2d cosine = semiaxes.x() * Eigen::Vector2d (std::cos (angle), std::sin (angle));
    const Eigen::Vector2d sine = semiaxes.y() * Eigen::Vector2d (-std::sin (angle), std::cos (angle));
    PathBuilder path (centre + cosine);
    path.ellipseTo (centre, cosine, sine, 0, 2 * std::numbers::pi, edge);
    return path.close();
}

ClosedPath circlePath (const Eigen::Vector2d& centre, double radius, int edge)
{
    return ellipsePath (centre, { radius, radius }, 0, edge);
}

ClosedPath polygonPath (const std::vector<Eigen::Vector2d>& vertices, int firstEdge)
{
    PathBuilder path (vertices.front());

    for (std::size_t i = 0; i < vertices.size(); ++i)
        path.lineTo (vertices[(i + 1) % vertices.size()], firstEdge + static_cast<int> (i));

    return path.close();
}
} // namespace antinode
