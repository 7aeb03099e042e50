#include "Outline.h"

#include "PathBuilder.h"

#include <antinode_numerics/GaussLegendre.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
/** The integral of x dy along a piece. */
double areaBeside (const PathPiece& piece)
{
    if (piece.isStraight)
        return (piece.start.x() + piece.end.x()) / 2 * (piece.end.y() - piece.start.y());

    static const auto rule = gaussLegendre (12, 1);
    const auto span = piece.to - piece.from;
    double sum = 0;

    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
    {
        const auto t = piece.from + span * rule.nodes[i];
        sum += rule.weights[i] * piece.at (t).x() * piece.derivative (t).y();
    }

    return sum * span;
}

/** What a function gives for every piece, as an outline. */
template <typename Change>
Outline changed (Outline outline, const Change& change)
{
    for (auto& path : outline.paths)
        for (auto& piece : path)
            change (piece);

    return withMonotonePieces (std::move (outline));
}
} // namespace

bool Outline::contains (double x, double y) const
{
    auto isInside = false;

    for (const auto& path : paths)
        for (const auto& piece : path)
            if (const auto crossed = piece.crossing (PlaneAxis::y, y); crossed && *crossed > x)
                isInside = ! isInside;

    return isInside;
}

OutlineExtent extentOf (const Outline& outline)
{
    constexpr auto infinity = std::numeric_limits<double>::infinity();
    OutlineExtent extent { Eigen::Vector2d::Constant (infinity), Eigen::Vector2d::Constant (-infinity) };

    for (const auto& path : outline.paths)
        for (const auto& piece : path)
        {
            extent.least = extent.least.cwiseMin (piece.start);
            extent.largest = extent.largest.cwiseMax (piece.start);
        }

    return extent;
}

double signedArea (const ClosedPath& path)
{
    double area = 0;

    for (const auto& piece : path)
        area += areaBeside (piece);

    return area;
}

double areaOf (const Outline& outline)
{
    double area = 0;

    for (const auto& path : outline.paths)
        area += (&path == &outline.paths.front() ? 1 : -1) * std::abs (signedArea (path));

    return area;
}

double insideAtLeft (const Outline& outline, const ClosedPath& path)
{
    return (signedArea (path) > 0) == (&path == &outline.paths.front()) ? 1 : -1;
}

double lengthOfEdge (const Outline& outline, int edge)
{
    double length = 0;

    for (const auto& path : outline.paths)
        for (const auto& piece : path)
            if (piece.edge == edge)
                length += piece.length (piece.from, piece.to);

    return length;
}

Outline moved (const Outline& outline, double angle, const Eigen::Vector2d& shift)
{
    const Eigen::Vector2d along (std::cos (angle), std::sin (angle));
    const auto turn = [&] (const Eigen::Vector2d& v) -> Eigen::Vector2d {
        return { along.x() * v.x() - along.y() * v.y(), along.y() * v.x() + along.x() * v.y() };
    };

    return changed (outline,
                    [&] (PathPiece& piece)
                    {
                        piece.start = turn (piece.start) + shift;
                        piece.end = turn (piece.end) + shift;
                        piece.centre = turn (piece.centre) + shift;
                        piece.cosine = turn (piece.cosine);
                        piece.sine = turn (piece.sine);
                    });
}

Outline scaled (const Outline& outline, double factor)
{
    return changed (outline,
                    [&] (PathPiece& piece)
                    {
                        for (auto* vector : { &piece.start, &piece.end, &piece.centre, &piece.cosine, &piece.sine })
                            *vector *= factor;
                    });
}

std::vector<double> crossings (const Outline& outline, PlaneAxis axis, double value)
{
    std::vector<double> places;

    for (const auto& path : outline.paths)
        for (const auto& piece : path)
            if (const auto crossed = piece.crossing (axis, value))
                places.push_back (*crossed);

    std::sort (places.begin(), places.end());
    return places;
}

Eigen::Vector2d nearestOnBoundary (const Outline& outline, double x, double y)
{
    const Eigen::Vector2d place (x, y);
    Eigen::Vector2d nearest = place;
    auto least = std::numeric_limits<double>::infinity();

    for (const auto& path : outline.paths)
        for (const auto& piece : path)
        {
            const auto candidate = piece.nearest (place);

            if (const auto square = (candidate - place).squaredNorm(); square < least)
            {
                least = square;
                nearest = candidate;
            }
        }

    return nearest;
}

double distanceToBoundary (const Outline& outline, double x, double y)
{
    return (nearestOnBoundary (outline, x, y) - Eigen::Vector2d (x, y)).norm();
}
} // namespace antinode
