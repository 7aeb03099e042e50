#include "PathBuilder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
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

namespace
{
double crossOf (const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/** The bulge of an arc along a chord that starts in a direction. */
double bulgeOf (const Eigen::Vector2d& direction, const Eigen::Vector2d& chord)
{
    return std::tan (std::atan2 (crossOf (direction, chord), direction.dot (chord)) / 2);
}

/** How far a place lies from a circle through the ends of a chord, of which the part with that bulge is drawn. */
double distanceToArc (const Eigen::Vector2d& place, const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                      double bulge)
{
    const Eigen::Vector2d chord = end - start;
    const auto length = chord.norm();
    const Eigen::Vector2d offset = place - (start + end) / 2;
    const Eigen::Vector2d local (offset.dot (chord) / length, crossOf (chord, offset) / length);

    // The circle's equation times the bulge, so that it may be straight: its centre is at (0, middle / bulge).
    const auto middle = length * (1 - bulge * bulge) / 4;
    const auto value = bulge * (local.squaredNorm() - length * length / 4) - 2 * middle * local.y();
    return std::abs (value) / (2 * std::hypot (bulge * local.x(), bulge * local.y() - middle));
}

/** Two arcs that follow each other smoothly. */
struct Biarc
{
    Eigen::Vector2d start, middle, end;
    double first = 0, second = 0; ///< Bulges.

    double distance (const Eigen::Vector2d& place) const
    {
        return std::min (distanceToArc (place, start, middle, first), distanceToArc (place, middle, end, second));
    }
};

/** Of given ends and unit tangents there, with tangents of equal length to the joint; nothing where there is none. */
std::optional<Biarc> biarcBetween (const Eigen::Vector2d& start, const Eigen::Vector2d& in, const Eigen::Vector2d& end,
                                   const Eigen::Vector2d& out)
{
    constexpr double sharpest = 1; // Bulge of half a circle
    const Eigen::Vector2d chord = end - start;
    const auto along = chord.dot (in + out);
    const auto bend = 2 * (1 - in.dot (out));

    // The positive root of bend d^2 + 2 along d - |chord|^2, in a form that needs no division by the bend.
    const auto denominator = along + std::sqrt (along * along + bend * chord.squaredNorm());

    if (! (denominator > 1e-9 * chord.norm()))
        return std::nullopt;

    const auto reach = chord.squaredNorm() / denominator;
    Biarc biarc { start, (start + end + reach * (in - out)) / 2, end };
    biarc.first = bulgeOf (in, biarc.middle - start);
    biarc.second = -bulgeOf (-out, biarc.middle - end);

    if (! (std::abs (biarc.first) < sharpest && std::abs (biarc.second) < sharpest))
        return std::nullopt;

    return biarc;
}

/** The direction of a curve, also where its derivative vanishes at an end of a part of it. */
Eigen::Vector2d directionAt (const FreeCurve& curve, double parameter, double inwards)
{
    const Eigen::Vector2d slope = curve.slope (parameter);
    const Eigen::Vector2d ahead = curve.at (parameter + 1e-4 * inwards) - curve.at (parameter);
    const auto isLevel = slope.norm() * std::abs (1e-4 * inwards) < 0.1 * ahead.norm();
    return (isLevel ? Eigen::Vector2d (inwards < 0 ? -ahead : ahead) : slope).stableNormalized();
}

struct CurveFit
{
    PathBuilder& path;
    const FreeCurve& curve;
    double deviation;
    int edge;

    void draw (double from, double to, int halvings)
    {
        constexpr int mostHalvings = 14;
        const Eigen::Vector2d start = curve.at (from), end = curve.at (to), middle = curve.at ((from + to) / 2);

        if (std::max ((end - start).norm(), (middle - start).norm()) < deviation || halvings == mostHalvings)
        {
            path.lineTo (end, edge);
            return;
        }

        const auto biarc =
            biarcBetween (start, directionAt (curve, from, to - from), end, directionAt (curve, to, from - to));

        if (biarc && isNear (*biarc, from, to))
        {
            path.arcTo (biarc->middle, biarc->first, edge);
            path.arcTo (end, biarc->second, edge);
            return;
        }

        draw (from, (from + to) / 2, halvings + 1);
        draw ((from + to) / 2, to, halvings + 1);
    }

    bool isNear (const Biarc& biarc, double from, double to) const
    {
        constexpr int samples = 8;

        for (int i = 1; i < samples; ++i)
            if (! (biarc.distance (curve.at (from + (to - from) * i / samples)) <= deviation))
                return false;

        return true;
    }
};

/** The arc of an ellipse, from -angle to angle about its middle. */
struct DrawnArc
{
    Eigen::Vector2d centre, cosine, sine;
    double angle = 0;
};

/** The arc that a cubic curve stands for: its control points are an affine image of those by which programs write a
   part of a circle, at most a little more than a quarter, with handles of 4/3 tan (angle / 2). */
std::optional<DrawnArc> arcOf (const std::array<Eigen::Vector2d, 4>& points, double deviation)
{
    constexpr double smallest = 0.17, largest = 0.8; // rad: half of the arc
    constexpr double rounded = 0.01; // Of a quarter, whose handles some programs write with two decimals.
    const Eigen::Vector2d chord = (points[3] - points[0]) / 2, inner = (points[2] - points[1]) / 2;
    const Eigen::Vector2d rise = (points[1] + points[2] - points[0] - points[3]) / 2;

    if (! (std::abs (crossOf (chord, inner)) <= 2 * deviation * chord.norm()))
        return std::nullopt;

    // inner = (1 - 4/3 tan (angle / 2) cot (angle)) chord
    const auto share = inner.dot (chord) / chord.squaredNorm();
    auto angle = 2 * std::atan (std::sqrt (std::max ((3 * share - 1) / 2, 0.0)));

    if (std::abs (angle - std::numbers::pi / 4) < rounded)
        angle = std::numbers::pi / 4;

    if (! (angle >= smallest && angle <= largest) || std::abs (crossOf (chord, rise)) < deviation * chord.norm())
        return std::nullopt;

    // The tangents at the ends are those of the handles, rise + (1 - share) chord at the start.
    const auto height = 1 / (std::tan (angle) * std::sin (angle) * (1 - share));
    DrawnArc arc { {}, height * rise, chord / std::sin (angle), angle };
    arc.centre = (points[0] + points[3]) / 2 - std::cos (angle) * arc.cosine;
    return arc;
}

bool isLine (const std::array<Eigen::Vector2d, 4>& points, double deviation)
{
    const Eigen::Vector2d chord = points[3] - points[0];
    const auto isOnChord = [&] (const Eigen::Vector2d& place)
    {
        const auto along = (place - points[0]).dot (chord);
        return std::abs (crossOf (chord, place - points[0])) <= 1e-3 * deviation * chord.norm() && along >= 0
               && along <= chord.squaredNorm();
    };
    return isOnChord (points[1]) && isOnChord (points[2]);
}
} // namespace

void drawCurve (PathBuilder& path, const FreeCurve& curve, double from, double to, double deviation, int edge)
{
    CurveFit { path, curve, deviation, edge }.draw (from, to, 0);
}

void drawBezier (PathBuilder& path, const std::array<Eigen::Vector2d, 4>& p, double deviation, int edge)
{
    if (isLine (p, deviation))
        path.lineTo (p[3], edge);
    else if (const auto arc = arcOf (p, deviation))
        path.ellipseTo (arc->centre, arc->cosine, arc->sine, -arc->angle, arc->angle, edge);
    else
        drawCurve (path,
                   { [&p] (double t) -> Eigen::Vector2d
                     {
                         const auto s = 1 - t;
                         return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
                     },
                     [&p] (double t) -> Eigen::Vector2d
                     {
                         const auto s = 1 - t;
                         return 3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
                     } },
                   0, 1, deviation, edge);
}

ClosedPath rectanglePath (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle,
                          const std::array<double, 4>& radii, int firstEdge)
{
    const Eigen::Vector2d along = size.x() / 2 * Eigen::Vector2d (std::cos (angle), std::sin (angle));
    const Eigen::Vector2d across = size.y() / 2 * Eigen::Vector2d (-std::sin (angle), std::cos (angle));
    const std::array<Eigen::Vector2d, 4> corners { centre - along - across, centre + along - across,
                                                   centre + along + across, centre - along + across };
    const std::array<Eigen::Vector2d, 4> directions { along.normalized(), across.normalized(), -along.normalized(),
                                                      -across.normalized() };
    const auto bulge = std::tan (std::numbers::pi / 8); // Of a quarter of a circle.
    PathBuilder path (corners[0] - radii[0] * directions[3]);

    for (std::size_t i = 0; i < 4; ++i)
    {
        const auto next = (i + 1) % 4;
        const auto edge = firstEdge + static_cast<int> (i);
        path.arcTo (corners[i] + radii[i] * directions[i], bulge, edge);
        path.lineTo (corners[next] - radii[next] * directions[i], edge);
    }

    return path.close();
}

ClosedPath ellipsePath (const Eigen::Vector2d& centre, const Eigen::Vector2d& semiaxes, double angle, int edge)
{
    const Eigen::Vector2d cosine = semiaxes.x() * Eigen::Vector2d (std::cos (angle), std::sin (angle));
    const Eigen::Vector2d sine = semiaxes.y() * Eigen::Vector2d (-std::sin (angle), std::cos (angle));
    PathBuilder path (centre + cosine);
    path.ellipseTo (centre, cosine, sine, 0, 2 * std::numbers::pi, edge);
    return path.close();
}

ClosedPath circlePath (const Eigen::Vector2d& centre, double radius, int edge)
{
    return ellipsePath (centre, { radius, radius }, 0, edge);
}

ClosedPath polygonPath (const std::vector<Eigen::Vector2d>& vertices, int firstEdge)
{
    PathBuilder path (vertices.front());

    for (std::size_t i = 0; i < vertices.size(); ++i)
        path.lineTo (vertices[(i + 1) % vertices.size()], firstEdge + static_cast<int> (i));

    return path.close();
}
} // namespace antinode
