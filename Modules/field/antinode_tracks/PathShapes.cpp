#include "PathShapes.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double placeSpacing = 5e-4;  // m
constexpr Eigen::Index leastSteps = 3; // of a polynomial of third order
} // namespace

std::vector<PathShapes::Leg> PathShapes::legsOf (const TouchedPoint& point)
{
    std::vector<Leg> legs;
    Eigen::Index count = 0;

    for (std::size_t i = 1; i < point.path.size(); ++i)
    {
        const auto &from = point.path[i - 1], &to = point.path[i];
        const auto length = std::hypot (to.x - from.x, to.y - from.y);
        const auto steps = std::max (leastSteps, static_cast<Eigen::Index> (std::ceil (length / placeSpacing)));
        legs.push_back ({ from.time, to.time, count, steps });
        count += steps + 1;
    }

    return legs;
}

Eigen::Index PathShapes::placesAlong (const TouchedPoint& point)
{
    const auto legs = legsOf (point);
    return legs.empty() ? 1 : legs.back().first + legs.back().steps + 1;
}

PathShapes::PathShapes (const ModalModel& model, const TouchedPoint& point)
    : legs (legsOf (point)), table (model.coordinates(), placesAlong (point))
{
    if (legs.empty())
    {
        const auto place = placeAt (point, 0);
        table = shapesAt (model, place.x, place.y).transpose();
    }

    for (const auto& leg : legs)
        for (Eigen::Index i = 0; i <= leg.steps; ++i)
        {
            checkWatch();
            const auto share = static_cast<double> (i) / static_cast<double> (leg.steps);
            const auto place = placeAt (point, leg.begin + share * (leg.end - leg.begin));
            table.col (leg.first + i) = shapesAt (model, place.x, place.y).transpose();
        }
}

Eigen::VectorXd PathShapes::at (double time) const
{
    if (legs.empty() || time <= legs.front().begin)
        return table.col (0);

    if (time >= legs.back().end)
        return table.col (table.cols() - 1);

    const auto& leg = *std::find_if (legs.begin(), legs.end(), [&] (const Leg& one) { return time < one.end; });
    const auto at = (time - leg.begin) / (leg.end - leg.begin) * static_cast<double> (leg.steps);
    const auto first = std::clamp<Eigen::Index> (static_cast<Eigen::Index> (at) - 1, 0, leg.steps - leastSteps);
    const auto u = at - static_cast<double> (first);

    // Lagrange's polynomials of the places 0, 1, 2 and 3.
    const Eigen::Vector4d weights { -(u - 1) * (u - 2) * (u - 3) / 6, u * (u - 2) * (u - 3) / 2,
                                    -u * (u - 1) * (u - 3) / 2, u * (u - 1) * (u - 2) / 6 };
    return table.middleCols<leastSteps + 1> (leg.first + first) * weights;
}

std::vector<PathShapes> pathShapes (const ModalModel& model, const WaveformsDescription& description)
{
    requirePlaces (model.surface, description);
    std::vector<PathShapes> paths;

    for (const auto& point : touchedPoints (description))
        paths.emplace_back (model, point);

    return paths;
}
} // namespace antinode
