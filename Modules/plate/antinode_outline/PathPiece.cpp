#include "PathPiece.h"

#include <antinode_numerics/GaussLegendre.h>

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
} // namespace antinode
