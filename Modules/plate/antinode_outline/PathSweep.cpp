#include "PathSweep.h"

#include "PieceMeeting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>
#include <unordered_map>

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
} // namespace antinode
