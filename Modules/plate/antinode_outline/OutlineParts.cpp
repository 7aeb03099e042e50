#include "OutlineParts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
/** The index of the path that comes nearest to a place. */
std::size_t nearestPath (const Outline& outline, const Eigen::Vector2d& place)
{
    std::size_t best = 0;
    auto least = std::numeric_limits<double>::infinity();

    for (std::size_t i = 0; i < outline.paths.size(); ++i)
        for (const auto& piece : outline.paths[i])
            if (const auto distance = (piece.nearest (place) - place).norm(); distance < least)
            {
                least = distance;
                best = i;
            }

    return best;
}

double parameterOf (const PathPiece& piece, const Eigen::Vector2d& place)
{
    const Eigen::Vector2d size = (piece.end - piece.start).cwiseAbs();
    return size.x() > size.y() ? piece.parameterAt (PlaneAxis::x, place.x())
                               : piece.parameterAt (PlaneAxis::y, place.y());
}

/** Cuts a path at its place nearest to a given one.
    @return  the index of the piece that begins there */
std::size_t cutAt (ClosedPath& path, const Eigen::Vector2d& place)
{
    const auto distance = [&] (const PathPiece& piece) { return (piece.nearest (place) - place).norm(); };
    const auto nearest = std::min_element (path.begin(), path.end(),
                                           [&] (const auto& a, const auto& b) { return distance (a) < distance (b); });
    const auto index = static_cast<std::size_t> (nearest - path.begin());
    const auto parameter = parameterOf (*nearest, nearest->nearest (place));
    constexpr double least = 1e-6; // of a piece: a shorter one is not worth the cut
    const auto share = (parameter - nearest->from) / (nearest->to - nearest->from);

    if (share < least)
        return index;

    if (share > 1 - least)
        return (index + 1) % path.size();

    auto second = *nearest;
    nearest->to = second.from = parameter;
    nearest->end = second.start = nearest->at (parameter);
    path.insert (nearest + 1, second);
    return index + 1;
}
} // namespace

std::optional<Outline> withEdgeAlong (Outline outline, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int edge)
{
    const auto number = nearestPath (outline, from);

    if (number != nearestPath (outline, to))
        return {};

    auto& path = outline.paths[number];
    const auto isCounterClockwise = signedArea (path) > 0;
    const Eigen::Vector2d begin = isCounterClockwise ? from : to, finish = isCounterClockwise ? to : from;
    cutAt (path, begin);
    const auto last = cutAt (path, finish);
    const auto first = cutAt (path, begin); // It may have moved on by the other cut.

    for (auto i = first;; i = (i + 1) % path.size())
    {
        path[i].edge = edge;

        if ((i + 1) % path.size() == last)
            return outline;
    }
}

int lastEdge (const Outline& outline)
{
    auto last = -1;

    for (const auto& path : outline.paths)
        for (const auto& piece : path)
            last = std::max (last, piece.edge);

    return last;
}
} // namespace antinode
