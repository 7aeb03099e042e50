#include "Outline.h"

#include "PathBuilder.h"

#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
double coordinate (const Eigen::Vector2d& place, PlaneAxis axis)
{
    return axis == PlaneAxis::x ? place.x() : place.y();
}

PlaneAxis other (PlaneAxis axis)
{
    return axis == PlaneAxis::x ? PlaneAxis::y : PlaneAxis::x;
}

/** Whether an arc is that of a circle. */
bool isCircular (const PathPiece& piece)
{
    constexpr double equal = 1e-12;
    const auto square = piece.cosine.squaredNorm();
    return std::abs (piece.sine.squaredNorm() - square) <= equal * square
           && std::abs (piece.cosine.dot (piece.sine)) <= equal * square;
}

/** How far an angle lies outside an interval. */
double distanceTo (double angle, double low, double high)
{
    return std::max ({ low - angle, angle - high, 0.0 });
}
} // namespace

Eigen::Vector2d PathPiece::at (double parameter) const
{
    if (isStraight)
        return centre + parameter * cosine;

    return centre + std::cos (parameter) * cosine + std::sin (parameter) * sine;
}

Eigen::Vector2d PathPiece::derivative (double parameter) const
{
    if (isStraight)
        return cosine;

    return std::cos (parameter) * sine - std::sin (parameter) * cosine;
}

double PathPiece::parameterAt (PlaneAxis axis, double value) const
{
    const auto offset = value - coordinate (centre, axis);
    const auto low = std::min (from, to), high = std::max (from, to);

    if (isStraight)
        return std::clamp (offset / coordinate (cosine, axis), low, high);

    // A cos t + B sin t = R cos (t - phase) has two solutions in a turn; on the piece there is one.
    const auto phase = std::atan2 (coordinate (sine, axis), coordinate (cosine, axis));
    const auto radius = std::hypot (coordinate (sine, axis), coordinate (cosine, axis));
    const auto half = std::acos (std::clamp (offset / radius, -1.0, 1.0));
    const auto middle = (low + high) / 2;
    auto best = low;
    auto distance = std::numeric_limits<double>::infinity();

    for (const auto angle : { phase + half, phase - half })
    {
        const auto near = angle - 2 * std::numbers::pi * std::round ((angle - middle) / (2 * std::numbers::pi));

        if (const auto outside = distanceTo (near, low, high); outside < distance)
        {
            distance = outside;
            best = near;
        }
    }

    return std::clamp (best, low, high);
}

std::optional<double> PathPiece::crossing (PlaneAxis axis, double value) const
{
    if (value < least (axis) || value >= largest (axis))
        return std::nullopt;

    return coordinate (at (parameterAt (axis, value)), other (axis));
}

Eigen::Vector2d PathPiece::nearest (const Eigen::Vector2d& place) const
{
    const auto low = std::min (from, to), high = std::max (from, to);

    if (isStraight)
        return at (std::clamp ((place - centre).dot (cosine) / cosine.squaredNorm(), low, high));

    const auto nearer = [&] (const Eigen::Vector2d& a, const Eigen::Vector2d& b) -> const Eigen::Vector2d&
    { return (a - place).squaredNorm() <= (b - place).squaredNorm() ? a : b; };
    const auto& nearerEnd = nearer (start, end);

    if (isCircular (*this))
    {
        const Eigen::Vector2d offset = place - centre;
        const auto angle = std::atan2 (offset.dot (sine), offset.dot (cosine));
        const auto turns = std::round ((angle - (low + high) / 2) / (2 * std::numbers::pi));
        return nearer (at (std::clamp (angle - 2 * std::numbers::pi * turns, low, high)), nearerEnd);
    }

    // Convex enough within a quadrant for golden sections to find the nearest place.
    constexpr double section = 0.381966011250105;
    auto begin = low, finish = high;
    const auto distance = [&] (double t) { return (at (t) - place).squaredNorm(); };

    for (int i = 0; i < 40; ++i)
    {
        const auto a = begin + section * (finish - begin), b = finish - section * (finish - begin);
        (distance (a) < distance (b) ? finish : begin) = distance (a) < distance (b) ? b : a;
    }

    return nearer (at (begin), nearerEnd);
}

double PathPiece::least (PlaneAxis axis) const
{
    return std::min (coordinate (start, axis), coordinate (end, axis));
}

double PathPiece::largest (PlaneAxis axis) const
{
    return std::max (coordinate (start, axis), coordinate (end, axis));
}

double PathPiece::length (double begin, double finish) const
{
    if (isStraight)
        return cosine.norm() * std::abs (finish - begin);

    static const auto rule = gaussLegendre (12, 1);
    double sum = 0;

    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * derivative (begin + (finish - begin) * rule.nodes[i]).norm();

    return sum * std::abs (finish - begin);
}

PathPiece linePiece (const Eigen::Vector2d& start, const Eigen::Vector2d& end, int edge)
{
    PathPiece piece;
    piece.start = start;
    piece.end = end;
    piece.centre = start;
    piece.cosine = end - start;
    piece.sine.setZero();
    piece.edge = edge;
    return piece;
}

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
