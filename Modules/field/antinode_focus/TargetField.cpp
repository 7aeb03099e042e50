#include "TargetField.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double sincHalfWidth = 1.895494267033981; // sin (x) / x = 1/2

double sinc (double x)
{
    return std::abs (x) < 1e-8 ? 1.0 : std::sin (x) / x;
}

double bump (double u)
{
    return std::abs (u) < 1 ? std::exp (1 - 1 / (1 - u * u)) : 0.0;
}

/** One end of Tukey's window: 0 at the end, rising as a raised cosine to 1 at the taper's length. */
double tukey (double fromEnd, double taper)
{
    if (taper <= 0 || fromEnd >= taper)
        return 1;

    return 0.5 * (1 - std::cos (std::numbers::pi * std::max (fromEnd, 0.0) / taper));
}

/** The same by the distance from what holds a boundary. Outside it the window stays 0 where it is 0 at the edge. */
double boundaryFactor (const Surface& surface, double x, double y, double share)
{
    const auto& [outline, held] = *surface.boundary;
    const Eigen::Vector2d place (x, y);
    const auto taper =
        0.5 * share * std::min (surface.xMaximum - surface.xMinimum, surface.yMaximum - surface.yMinimum);
    auto distance = taper;

    for (const auto& piece : held)
        distance = std::min (distance, (piece.nearest (place) - place).norm());

    return distance >= taper ? 1.0 : outline.contains (x, y) ? tukey (distance, taper) : 0.0;
}

/** The window at a place: tapered at the edges that cannot move. */
double edgeFactor (const Surface& surface, double x, double y, double share)
{
    if (surface.boundary)
        return boundaryFactor (surface, x, y, share);

    const auto taperX = 0.5 * share * (surface.xMaximum - surface.xMinimum);
    const auto taperY = 0.5 * share * (surface.yMaximum - surface.yMinimum);
    const auto& held = surface.held;
    const auto left = held.left ? tukey (x - surface.xMinimum, taperX) : 1.0;
    const auto right = held.right ? tukey (surface.xMaximum - x, taperX) : 1.0;

    if (surface.kind == SurfaceKind::line)
        return left * right;

    const auto bottom = held.bottom ? tukey (y - surface.yMinimum, taperY) : 1.0;
    const auto top = held.top ? tukey (surface.yMaximum - y, taperY) : 1.0;
    return left * right * bottom * top;
}

double widthInY (const Target& target)
{
    return target.widthY.value_or (target.width);
}

/** From the target's centre, m. */
Eigen::Vector2d offsetFrom (const Surface& surface, double x, double y, const Target& target)
{
    return { x - target.x, surface.kind == SurfaceKind::line ? 0.0 : y - target.y };
}

double profileAt (const Surface& surface, double x, double y, const Target& target)
{
    const auto offset = offsetFrom (surface, x, y, target);

    if (target.profile == TargetProfile::radial)
        return targetProfile (target.shape, offset.norm(), target.width);

    return targetProfile (target.shape, offset.x(), target.width)
           * targetProfile (target.shape, offset.y(), widthInY (target));
}

/** The distance from the target's centre in widths, each axis in its own: the spot ends at 1. */
double widthsAway (const Surface& surface, Eigen::Index point, const Target& target)
{
    const auto offset = offsetFrom (surface, surface.points (point, 0), surface.points (point, 1), target);
    return std::hypot (offset.x() / target.width, offset.y() / widthInY (target));
}
} // namespace

double targetProfile (TargetShape shape, double distance, double width)
{
    const auto relative = 2 * distance / width; // 1 at half maximum

    switch (shape)
    {
        case TargetShape::sinc:
            return sinc (sincHalfWidth * relative);
        case TargetShape::bump:
            // Half maximum where 1/(1 - u^2) = 1 + ln 2.
            return bump (relative * std::sqrt (std::numbers::ln2 / (1 + std::numbers::ln2)));
        case TargetShape::gaussian:
            return std::exp (-std::numbers::ln2 * relative * relative);
    }

    return 0;
}

double targetVelocity (const Surface& surface, const std::vector<Target>& targets, std::optional<double> edgeWindow,
                       double x, double y)
{
    double velocity = 0;

    for (const auto& target : targets)
        velocity += target.phase * target.peakVelocity * profileAt (surface, x, y, target);

    return edgeWindow ? velocity * edgeFactor (surface, x, y, *edgeWindow) : velocity;
}

Eigen::VectorXd targetField (const Surface& surface, const std::vector<Target>& targets,
                             std::optional<double> edgeWindow)
{
    Eigen::VectorXd field (surface.points.rows());

    for (Eigen::Index i = 0; i < field.size(); ++i)
        field[i] = targetVelocity (surface, targets, edgeWindow, surface.points (i, 0), surface.points (i, 1));

    return field;
}

double fieldContrast (const Surface& surface, const Eigen::VectorXd& field, const std::vector<Target>& targets,
                      double peak)
{
    double square = 0, area = 0;

    for (Eigen::Index i = 0; i < field.size(); ++i)
    {
        const auto outside = std::all_of (targets.begin(), targets.end(),
                                          [&] (const Target& target) { return widthsAway (surface, i, target) > 1; });

        if (outside)
        {
            square += surface.areas[i] * field[i] * field[i];
            area += surface.areas[i];
        }
    }

    return square > 0 ? std::abs (peak) / std::sqrt (square / area) : 0.0;
}
} // namespace antinode
