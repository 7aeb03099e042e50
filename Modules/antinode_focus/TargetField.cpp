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

/** 1 inside, falling as a raised cosine to 0 at the ends. */
double tukey (double position, double minimum, double maximum, double share)
{
    const auto taper = 0.5 * share * (maximum - minimum);
    const auto fromEnd = std::min (position - minimum, maximum - position);

    if (taper <= 0 || fromEnd >= taper)
        return 1;

    return 0.5 * (1 - std::cos (std::numbers::pi * std::max (fromEnd, 0.0) / taper));
}

double distanceTo (const Surface& surface, Eigen::Index point, const Target& target)
{
    const auto dx = surface.points (point, 0) - target.x;
    return surface.kind == SurfaceKind::line ? std::abs (dx) : std::hypot (dx, surface.points (point, 1) - target.y);
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

Eigen::VectorXd targetField (const Surface& surface, const std::vector<Target>& targets,
                             std::optional<double> edgeWindow)
{
    Eigen::VectorXd field = Eigen::VectorXd::Zero (surface.points.rows());

    for (Eigen::Index i = 0; i < field.size(); ++i)
    {
        for (const auto& target : targets)
            field[i] += target.phase * target.peakVelocity
                        * targetProfile (target.shape, distanceTo (surface, i, target), target.width);

        if (edgeWindow)
        {
            field[i] *= tukey (surface.points (i, 0), surface.xMinimum, surface.xMaximum, *edgeWindow);

            if (surface.kind == SurfaceKind::plate)
                field[i] *= tukey (surface.points (i, 1), surface.yMinimum, surface.yMaximum, *edgeWindow);
        }
    }

    return field;
}

double fieldContrast (const Surface& surface, const Eigen::VectorXd& field, const std::vector<Target>& targets)
{
    double square = 0, area = 0;

    for (Eigen::Index i = 0; i < field.size(); ++i)
    {
        const auto outside =
            std::all_of (targets.begin(), targets.end(),
                         [&] (const Target& target) { return distanceTo (surface, i, target) > target.width; });

        if (outside)
        {
            square += surface.areas[i] * field[i] * field[i];
            area += surface.areas[i];
        }
    }

    return square > 0 ? field.cwiseAbs().maxCoeff() / std::sqrt (square / area) : 0.0;
}
} // namespace antinode
