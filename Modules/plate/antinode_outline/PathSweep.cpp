#include "PathSweep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace antinode
{
namespace
{
/** A piece, and what the sweep asks of it. */
struct SweptPiece
{
    PathPiece piece;
    std::size_t path = 0;
    bool isInsideAbove = false; ///< Of its own path.

    bool runsRight() const { return isBefore (piece.start, piece.end); }
    const Eigen::Vector2d& left() const { return runsRight() ? piece.start : piece.end; }
    const Eigen::Vector2d& right() const { return runsRight() ? piece.end : piece.start; }

    /** As if the plane were sheared by nearly nothing, so that no piece is vertical. */
    static bool isBefore (const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    }

    double heightAt (double x) const
    {
        // Of a line that is vertical but for rounding, the height at an x says nothing.
        constexpr double vertical = 1e-12;

        if (right().x() - left().x() <= vertical * (std::abs (left().x()) + std::abs (right().y() - left().y())))
            return (left().y() + right().y()) / 2;

        return piece.at (piece.parameterAt (PlaneAxis::x, x)).y();
    }
};

/** Where two pieces that share a range of x lie one above the other. Pieces that do not cross do so everywhere in that
   range, so its middle decides, in which they do not share an end. */
bool isBelow (const SweptPiece& a, const SweptPiece& b)
{
    const auto from = std::max (a.left().x(), b.left().x()), to = std::min (a.right().x(), b.right().x());
    const auto middle = (from + to) / 2;
    return a.heightAt (middle) < b.heightAt (middle);
}

struct PieceOrder
{
    bool operator() (const SweptPiece* a, const SweptPiece* b) const { return isBelow (*a, *b); }
};

struct SweepEvent
{
    const SweptPiece* piece = nullptr;
    bool isStart = false;

    const Eigen::Vector2d& place() const { return isStart ? piece->left() : piece->right(); }
};

/** A path whose pieces are longer than a length: those that arcs have where x or y turns back near their ends may not
 * be.
 */
ClosedPath withoutShortPieces (const ClosedPath& path, double shortest)
{
    ClosedPath kept;

    for (const auto& piece : path)
    {
        const auto start = kept.empty() ? path.front().start : kept.back().end;

        if ((piece.end - start).norm() < shortest)
            continue;

        kept.push_back (piece);
        kept.back().start = start;
    }

    if (! kept.empty())
        kept.back().end = kept.front().start;

    return kept;
}

std::vector<SweptPiece> sweptPieces (const std::vector<ClosedPath>& paths, double tolerance)
{
    std::vector<SweptPiece> pieces;

    for (std::size_t p = 0; p < paths.size(); ++p)
    {
        const auto isCounterClockwise = signedArea (paths[p]) > 0;

        for (const auto& piece : withoutShortPieces (paths[p], 4 * tolerance))
        {
            SweptPiece swept { piece, p, false };
            swept.isInsideAbove = swept.runsRight() == isCounterClockwise;
            pieces.push_back (swept);
        }
    }

    return pieces;
}

/** Ends before beginnings at one place. */
std::vector<SweepEvent> sweepEvents (const std::vector<SweptPiece>& pieces)
{
    std::vector<SweepEvent> events;
    events.reserve (2 * pieces.size());

    for (const auto& piece : pieces)
        for (const auto isStart : { false, true })
            events.push_back ({ &piece, isStart });

    std::sort (events.begin(), events.end(),
               [] (const SweepEvent& a, const SweepEvent& b)
               {
                   return std::tuple (a.place().x(), a.place().y(), a.isStart)
                          < std::tuple (b.place().x(), b.place().y(), b.isStart);
               });

    return events;
}

PathConflict conflictOf (const SweptPiece& a, const SweptPiece& b, const Eigen::Vector2d& place)
{
    return { std::min (a.path, b.path), std::max (a.path, b.path), place };
}

/** Two corners, of whatever paths, that are nearer to each other than the tolerance. */
std::optional<PathConflict> nearCorners (const std::vector<SweptPiece>& pieces, double tolerance)
{
    const auto cellOf = [&] (const Eigen::Vector2d& place, int right, int up)
    {
        const auto column = static_cast<std::int64_t> (std::floor (place.x() / tolerance)) + right;
        const auto row = static_cast<std::int64_t> (std::floor (place.y() / tolerance)) + up;
        return static_cast<std::uint64_t> (column) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t> (row);
    };
    std::unordered_map<std::uint64_t, const SweptPiece*> cells;
    cells.reserve (pieces.size());

    for (const auto& swept : pieces)
    {
        for (const auto right : { -1, 0, 1 })
            for (const auto up : { -1, 0, 1 })
                if (const auto found = cells.find (cellOf (swept.piece.start, right, up));
                    found != cells.end() && (found->second->piece.start - swept.piece.start).norm() <= tolerance)
                    return conflictOf (*found->second, swept, swept.piece.start);

        cells.emplace (cellOf (swept.piece.start, 0, 0), &swept);
    }

    return std::nullopt;
}

/** The line of equal x, and the pieces that it crosses. */
class Sweep
{
public:
    Sweep (std::size_t paths, const std::vector<SweptPiece>& all, double smallest)
        : tolerance (smallest), pieces (all), isKnown (paths), places (all.size())
    {
        nesting.around.resize (paths);
    }

    /** False where a conflict ends it. */
    bool insert (const SweptPiece& swept)
    {
        const auto [found, isNew] = crossed.insert (&swept);

        if (! isNew)
            return refuse (swept, **found, meeting (swept.piece, (*found)->piece, tolerance).value_or (swept.left()));

        const auto below = found == crossed.begin() ? nullptr : *std::prev (found);
        const auto above = std::next (found) == crossed.end() ? nullptr : *std::next (found);

        places[indexOf (swept)] = found;

        if (! isKnown[swept.path])
            nesting.around[swept.path] = pathAround (below);

        isKnown[swept.path] = true;
        return staysApart (below, &swept) && staysApart (&swept, above);
    }

    bool remove (const SweptPiece& swept)
    {
        const auto above = crossed.erase (places[indexOf (swept)]);
        return above == crossed.begin() || above == crossed.end() || staysApart (*std::prev (above), *above);
    }

    PathNesting nesting;

private:
    /** Of a path whose first place lies above a piece. */
    std::optional<std::size_t> pathAround (const SweptPiece* below) const
    {
        if (below == nullptr)
            return std::nullopt;

        return below->isInsideAbove ? below->path : nesting.around[below->path];
    }

    bool staysApart (const SweptPiece* a, const SweptPiece* b)
    {
        if (a == nullptr || b == nullptr)
            return true;

        const auto met = meeting (a->piece, b->piece, tolerance);
        return ! met || refuse (*a, *b, *met);
    }

    bool refuse (const SweptPiece& a, const SweptPiece& b, const Eigen::Vector2d& place)
    {
        nesting.conflict = conflictOf (a, b, place);
        return false;
    }

    std::size_t indexOf (const SweptPiece& swept) const { return static_cast<std::size_t> (&swept - pieces.data()); }

    using Crossed = std::set<const SweptPiece*, PieceOrder>;

    double tolerance;
    const std::vector<SweptPiece>& pieces;
    std::vector<bool> isKnown;
    Crossed crossed;
    std::vector<Crossed::iterator> places; ///< Of the pieces that are crossed.
};
} // namespace

PathNesting nestingOf (const std::vector<ClosedPath>& paths, double tolerance)
{
    const auto pieces = sweptPieces (paths, tolerance);
    Sweep sweep (paths.size(), pieces, tolerance);
    sweep.nesting.conflict = nearCorners (pieces, tolerance);

    if (! sweep.nesting.conflict)
        for (const auto& event : sweepEvents (pieces))
            if (! (event.isStart ? sweep.insert (*event.piece) : sweep.remove (*event.piece)))
                break;

    return std::move (sweep.nesting);
}

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
