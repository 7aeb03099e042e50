#include "PieceMeeting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace antinode
{
namespace
{
/** A part of a piece: its chord, and how far it may leave it. */
struct Chord
{
    double from = 0, to = 0;
    Eigen::Vector2d start, end;
    double sagitta = 0;
};

Chord chordOf (const PathPiece& piece, double from, double to)
{
    const auto span = to - from;
    const auto bend = piece.isStraight ? 0.0 : std::hypot (piece.cosine.norm(), piece.sine.norm());
    return { from, to, piece.at (from), piece.at (to), span * span / 8 * bend };
}

double cross (const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/** The nearest distance between chords, and where. */
struct Approach
{
    double distance = std::numeric_limits<double>::infinity();
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

void considerPlace (Approach& approach, const Eigen::Vector2d& place, const Chord& chord)
{
    const Eigen::Vector2d along = chord.end - chord.start;
    const auto share =
        std::clamp ((place - chord.start).dot (along) / std::max (along.squaredNorm(), 1e-300), 0.0, 1.0);

    if (const auto distance = (chord.start + share * along - place).norm(); distance < approach.distance)
        approach = { distance, place };
}

Approach approachOf (const Chord& a, const Chord& b)
{
    const Eigen::Vector2d alongA = a.end - a.start, alongB = b.end - b.start, between = b.start - a.start;

    // Of nearly parallel chords the ends say as much, and rounding would say anything.
    if (const auto turn = cross (alongA, alongB); std::abs (turn) > 1e-12 * alongA.norm() * alongB.norm())
    {
        const auto atA = cross (between, alongB) / turn, atB = cross (between, alongA) / turn;

        if (atA >= 0 && atA <= 1 && atB >= 0 && atB <= 1)
            return { 0, a.start + atA * alongA };
    }

    Approach approach;
    considerPlace (approach, a.start, b);
    considerPlace (approach, a.end, b);
    considerPlace (approach, b.start, a);
    considerPlace (approach, b.end, a);
    return approach;
}

/** The part of a piece that is farther than a radius from a place, which is one of its ends, or near none. */
Chord awayFrom (const PathPiece& piece, Chord chord, const Eigen::Vector2d& place, double radius)
{
    if (piece.start != place && piece.end != place)
        return chord;

    // The distance from an end grows along a piece that neither coordinate turns back on.
    auto& near = piece.start == place ? chord.from : chord.to;
    auto within = near, beyond = piece.start == place ? chord.to : chord.from;

    for (int i = 0; i < 40; ++i)
    {
        const auto middle = (within + beyond) / 2;
        ((piece.at (middle) - place).norm() < radius ? within : beyond) = middle;
    }

    near = beyond;
    return chordOf (piece, chord.from, chord.to);
}

/** The same as meeting(), of parts of pieces. */
std::optional<Eigen::Vector2d> meetingOf (const PathPiece& a, const Chord& wholeA, const PathPiece& b,
                                          const Chord& wholeB, double tolerance)
{
    std::vector<std::pair<Chord, Chord>> open { { wholeA, wholeB } };

    while (! open.empty())
    {
        const auto [partA, partB] = open.back();
        open.pop_back();
        const auto approach = approachOf (partA, partB);
        const auto bend = partA.sagitta + partB.sagitta;

        if (approach.distance > tolerance + bend)
            continue;

        if (bend < tolerance / 4)
            return approach.place;

        const auto cutsA = partA.sagitta > partB.sagitta;
        const auto& piece = cutsA ? a : b;
        const auto& part = cutsA ? partA : partB;
        const auto middle = (part.from + part.to) / 2;

        for (const auto& half : { chordOf (piece, part.from, middle), chordOf (piece, middle, part.to) })
            open.emplace_back (cutsA ? half : partA, cutsA ? partB : half);
    }

    return std::nullopt;
}
} // namespace

std::optional<Eigen::Vector2d> meeting (const PathPiece& a, const PathPiece& b, double tolerance)
{
    for (const auto axis : { PlaneAxis::x, PlaneAxis::y })
        if (a.least (axis) > b.largest (axis) + tolerance || b.least (axis) > a.largest (axis) + tolerance)
            return std::nullopt;

    auto chordA = chordOf (a, a.from, a.to);
    const auto chordB = chordOf (b, b.from, b.to);
    const auto shorter = std::min ((a.end - a.start).norm(), (b.end - b.start).norm());
    const auto radius = std::max (0.01 * shorter, 10 * tolerance);

    for (const auto& end : { b.start, b.end })
        chordA = awayFrom (a, chordA, end, radius);

    return meetingOf (a, chordA, b, chordB, tolerance);
}
} // namespace antinode
