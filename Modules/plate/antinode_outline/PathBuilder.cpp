#include "PathBuilder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
/** Where along a piece its x or its y turns back, from its start to its end. */
std::vector<double> turns (const PathPiece& piece)
{
    const auto low = std::min (piece.from, piece.to), high = std::max (piece.from, piece.to);
    constexpr double least = 1e-9; // rad: a shorter piece is not worth the cut.
    std::vector<double> angles;

    for (const auto first :
         { std::atan2 (piece.sine.x(), piece.cosine.x()), std::atan2 (piece.sine.y(), piece.cosine.y()) })
        for (auto k = std::ceil ((low + least - first) / std::numbers::pi);; ++k)
        {
            const auto angle = first + k * std::numbers::pi;

            if (! (angle < high - least)) // Nor where it is no number.
                break;

            angles.push_back (angle);
        }

    std::sort (angles.begin(), angles.end());
    angles.erase (std::unique (angles.begin(), angles.end(), [] (double a, double b) { return b - a < least; }),
                  angles.end());

    if (piece.to < piece.from)
        std::reverse (angles.begin(), angles.end());

    return angles;
}

void addMonotone (ClosedPath& path, const PathPiece& piece)
{
    auto part = piece;

    if (! piece.isStraight)
        for (const auto angle : turns (piece))
        {
            part.to = angle;
            part.end = piece.at (angle);
            path.push_back (part);
            part.from = angle;
            part.start = part.end;
        }

    part.to = piece.to;
    part.end = piece.end;
    path.push_back (part);
}
} // namespace

PathBuilder::PathBuilder (const Eigen::Vector2d& start) : first (start), place (start) {}

void PathBuilder::lineTo (const Eigen::Vector2d& end, int edge)
{
    if (end != place)
        pieces.push_back (linePiece (place, end, edge));

    place = end;
}

void PathBuilder::arcTo (const Eigen::Vector2d& end, double bulge, int edge)
{
    constexpr double straight = 1e-8; // A flatter arc has a centre so far away that places on it lose their digits.

    if (std::abs (bulge) < straight || end == place)
    {
        lineTo (end, edge);
        return;
    }

    // The centre lies on the perpendicular through the chord's middle.
    const Eigen::Vector2d chord = end - place;
    const Eigen::Vector2d left (-chord.y(), chord.x());
    const Eigen::Vector2d centre = (place + end) / 2 + left * (1 - bulge * bulge) / (4 * bulge);
    const auto radius = (place - centre).norm();
    const auto from = std::atan2 (place.y() - centre.y(), place.x() - centre.x());
    ellipseTo (centre, { radius, 0 }, { 0, radius }, from, from + 4 * std::atan (bulge), edge);
    endAt (end);
}

void PathBuilder::endAt (const Eigen::Vector2d& end)
{
    pieces.back().end = place = end;
}

void PathBuilder::ellipseTo (const Eigen::Vector2d& centre, const Eigen::Vector2d& cosine, const Eigen::Vector2d& sine,
                             double from, double to, int edge)
{
    PathPiece piece;
    piece.isStraight = false;
    piece.centre = centre;
    piece.cosine = cosine;
    piece.sine = sine;
    piece.from = from;
    piece.to = to;
    piece.edge = edge;
    piece.start = place;
    piece.end = place = piece.at (to);
    pieces.push_back (piece);
}

ClosedPath PathBuilder::close() const
{
    ClosedPath path;

    for (const auto& piece : pieces)
        addMonotone (path, piece);

    if (! path.empty())
        path.back().end = path.front().start = first;

    return path;
}

Outline withMonotonePieces (Outline outline)
{
    for (auto& path : outline.paths)
    {
        ClosedPath cut;

        for (const auto& piece : path)
            addMonotone (cut, piece);

        // What was one place stays one.
        for (std::size_t i = 0; i < cut.size(); ++i)
            cut[i].end = cut[(i + 1) % cut.size()].start;

        path = std::move (cut);
    }

    return outline;
}
} // namespace antinode
