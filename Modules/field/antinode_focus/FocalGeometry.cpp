#include "FocalGeometry.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
bool liesIn (const FocalSpot& spot, bool isLine, double x, double y)
{
    constexpr double onBoundary = 1 - 1e-9;
    return std::hypot ((x - spot.x) / spot.radiusX, isLine ? 0.0 : (y - spot.y) / spot.radiusY) < onBoundary;
}
} // namespace

bool liesOutside (const std::vector<FocalSpot>& spots, bool isLine, double x, double y)
{
    return std::none_of (spots.begin(), spots.end(),
                         [&] (const FocalSpot& spot) { return liesIn (spot, isLine, x, y); });
}

FieldPeak placeOnBoundary (const FocalSpot& spot, double angle)
{
    return { spot.x + spot.radiusX * std::cos (angle), spot.y + spot.radiusY * std::sin (angle) };
}
} // namespace antinode
