#include "BankPlaces.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** The position of one of several along a side, from margin to margin. */
double along (double minimum, double maximum, double margin, int index, int count)
{
    const auto kept = std::min (margin, (maximum - minimum) / 3);
    const auto share = count > 1 ? static_cast<double> (index) / (count - 1) : 0.5;
    return minimum + kept + share * (maximum - minimum - 2 * kept);
}
} // namespace

std::vector<std::pair<double, double>> bankPlaces (const Surface& surface, int count, double margin)
{
    if (count < 1)
        return {};

    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto isLine = surface.kind == SurfaceKind::line || ! (height > 0);
    const auto columns =
        isLine ? count : std::clamp (static_cast<int> (std::lround (std::sqrt (count * width / height))), 1, count);
    const auto rows = (count + columns - 1) / columns;
    std::vector<std::pair<double, double>> places;
    places.reserve (static_cast<std::size_t> (count));

    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector2d place (along (surface.xMinimum, surface.xMaximum, margin, i % columns, columns),
                                     isLine ? 0.0
                                            : along (surface.yMinimum, surface.yMaximum, margin, i / columns, rows));
        const Eigen::Vector2d on = surface.boundary ? nearestOn (surface, place.x(), place.y()) : place;
        places.emplace_back (on.x(), on.y());
    }

    return places;
}

FocusDescription movedTo (FocusDescription focus, double x, double y)
{
    const auto shiftX = x - focus.targets.front().x, shiftY = y - focus.targets.front().y;

    for (auto& target : focus.targets)
    {
        target.x += shiftX;
        target.y += shiftY;
    }

    return focus;
}
} // namespace antinode
