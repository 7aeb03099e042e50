#include "Drawing.h"

#include "DxfReader.h"
#include "OutlineChecks.h"
#include "SvgReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace antinode
{
namespace
{
/** What begins with an element is XML. */
bool looksLikeXml (std::string_view bytes)
{
    const auto first = bytes.find_first_not_of (" \t\r\n\xef\xbb\xbf");
    return first != std::string_view::npos && bytes[first] == '<';
}

/** Edges in the order of the paths, from 0 on. */
void renumberEdges (Outline& outline)
{
    auto next = -1;

    for (auto& path : outline.paths)
    {
        auto drawn = -1;

        for (auto& piece : path)
        {
            next += piece.edge == drawn ? 0 : 1;
            drawn = piece.edge;
            piece.edge = next;
        }
    }
}
} // namespace

Outline outlineFromDrawing (std::string_view bytes, const std::string& source, const DrawingChoice& choice)
{
    if (bytes.substr (0, 2) == "\x1f\x8b")
        throw InputError (source, "is compressed; allowed: SVG and DXF as text");

    const auto isXml = looksLikeXml (bytes);
    auto strokes = isXml ? svgStrokes (bytes, source, choice) : dxfStrokes (bytes, source, choice);
    Outline outline { joinedStrokes (std::move (strokes), choice.joint) };

    if (outline.paths.empty())
        throw InputError (source, "shows no closed path; allowed: an outline, and holes in it");

    // The largest is the outer one; the others stay in the order in which they were drawn.
    const auto largest = std::max_element (outline.paths.begin(), outline.paths.end(),
                                           [] (const ClosedPath& a, const ClosedPath& b)
                                           { return std::abs (signedArea (a)) < std::abs (signedArea (b)); });
    std::rotate (outline.paths.begin(), largest, largest + 1);
    renumberEdges (outline);
    outline = withMonotonePieces (std::move (outline));
    checkOutline (outline, source);
    return outline;
}

Outline readOutlineFile (const std::filesystem::path& path, const DrawingChoice& choice)
{
    constexpr FileKind kind { "an SVG or DXF drawing" };
    return outlineFromDrawing (readWholeFile (path, kind), path.string(), choice);
}

namespace
{
const Eigen::Vector2d& startOf (const Stroke& stroke)
{
    return stroke.pieces.front().start;
}

const Eigen::Vector2d& endOf (const Stroke& stroke)
{
    return stroke.pieces.back().end;
}

std::string placeText (const Eigen::Vector2d& place)
{
    return "(" + inWords (1000 * place.x()) + ", " + inWords (1000 * place.y()) + ") mm";
}

/** A product of places as complex numbers: turned and enlarged. */
Eigen::Vector2d turnedBy (const Eigen::Vector2d& turn, const Eigen::Vector2d& v)
{
    return { turn.x() * v.x() - turn.y() * v.y(), turn.x() * v.y() + turn.y() * v.x() };
}

/** A piece with other ends nearby: moved, turned and enlarged, so that an arc stays one. */
PathPiece withEnds (PathPiece piece, const Eigen::Vector2d& start, const Eigen::Vector2d& end)
{
    if (piece.start == start && piece.end == end)
        return piece;

    if (piece.isStraight)
        return linePiece (start, end, piece.edge);

    const Eigen::Vector2d from = piece.end - piece.start, to = end - start;
    const Eigen::Vector2d conjugate (from.x(), -from.y());
    Eigen::Vector2d turn = turnedBy (conjugate, to) / from.squaredNorm();

    // Of an arc whose ends nearly meet the chord says nothing.
    if (! ((turn - Eigen::Vector2d::UnitX()).norm() < 0.1))
        turn = Eigen::Vector2d::UnitX();

    piece.centre = start + turnedBy (turn, piece.centre - piece.start);
    piece.cosine = turnedBy (turn, piece.cosine);
    piece.sine = turnedBy (turn, piece.sine);
    piece.start = start;
    piece.end = end;
    return piece;
}

Stroke reversed (Stroke stroke)
{
    std::reverse (stroke.pieces.begin(), stroke.pieces.end());

    for (auto& piece : stroke.pieces)
    {
        const auto edge = piece.edge;
        std::swap (piece.start, piece.end);
        std::swap (piece.from, piece.to);

        if (piece.isStraight)
            piece = linePiece (piece.start, piece.end, edge);
    }

    return stroke;
}

/** Without pieces that are shorter than a length. */
void dropShort (Stroke& stroke, double shortest)
{
    std::vector<PathPiece> kept;

    for (const auto& piece : stroke.pieces)
        if (piece.length (piece.from, piece.to) >= shortest)
            kept.push_back (kept.empty() ? piece : withEnds (piece, kept.back().end, piece.end));

    stroke.pieces = std::move (kept);
}

/** The ends of open strokes by their places. End 2 s is the start of stroke s, 2 s + 1 its end. */
class Ends
{
public:
    Ends (const std::vector<Stroke>& all, double distance) : strokes (all), tolerance (distance)
    {
        cells.reserve (2 * strokes.size());

        for (std::size_t end = 0; end < 2 * strokes.size(); ++end)
            cells.emplace (cellOf (placeOf (end), 0, 0), end);
    }

    const Eigen::Vector2d& placeOf (std::size_t end) const
    {
        return end % 2 == 0 ? startOf (strokes[end / 2]) : endOf (strokes[end / 2]);
    }

    /** Others that lie within the tolerance, the nearest first. */
    std::vector<std::size_t> nearTo (std::size_t end) const
    {
        std::vector<std::size_t> found;

        for (const auto right : { -1, 0, 1 })
            for (const auto up : { -1, 0, 1 })
            {
                const auto [first, last] = cells.equal_range (cellOf (placeOf (end), right, up));

                for (auto other = first; other != last && found.size() < most; ++other)
                    if (other->second != end && distance (end, other->second) <= tolerance)
                        found.push_back (other->second);
            }

        std::sort (found.begin(), found.end());
        found.erase (std::unique (found.begin(), found.end()), found.end());
        std::sort (found.begin(), found.end(), [&] (auto a, auto b) { return distance (end, a) < distance (end, b); });
        return found;
    }

    /** The end with which another belongs together. */
    std::size_t partnerOf (std::size_t end) const
    {
        const auto found = nearTo (end);

        if (found.size() > 1)
            throw InputError (strokes[end / 2].name,
                              std::to_string (found.size() + 1) + (found.size() + 1 < most ? "" : " or more")
                                  + " ends meet at " + placeText (placeOf (end)) + "; allowed: 2, or choose a layer");

        if (found.empty())
            throw InputError (strokes[end / 2].name, "is open at " + placeText (placeOf (end)) + nearestText (end)
                                                         + "; allowed: closed paths, with gaps of at most "
                                                         + inWords (1000 * tolerance) + " mm, or choose a layer");

        return found.front();
    }

private:
    static constexpr std::size_t most = 8; ///< More ends at one place are not told apart.

    double distance (std::size_t a, std::size_t b) const { return (placeOf (a) - placeOf (b)).norm(); }

    std::string nearestText (std::size_t end) const
    {
        auto nearest = std::numeric_limits<double>::infinity();

        for (std::size_t other = 0; other < 2 * strokes.size(); ++other)
            if (other != end)
                nearest = std::min (nearest, distance (end, other));

        return ", " + inWords (1000 * nearest) + " mm from the nearest end";
    }

    std::uint64_t cellOf (const Eigen::Vector2d& place, int right, int up) const
    {
        const auto column = static_cast<std::int64_t> (std::floor (place.x() / tolerance)) + right;
        const auto row = static_cast<std::int64_t> (std::floor (place.y() / tolerance)) + up;
        return static_cast<std::uint64_t> (column) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t> (row);
    }

    const std::vector<Stroke>& strokes;
    double tolerance;
    std::unordered_multimap<std::uint64_t, std::size_t> cells;
};

/** Pieces in a row as a closed path: where one ends the next begins. */
ClosedPath closedPath (const std::vector<Stroke>& chain, double shortest)
{
    Stroke whole;
    auto& pieces = whole.pieces;

    for (const auto& stroke : chain)
        for (const auto& piece : stroke.pieces)
            pieces.push_back (pieces.empty() ? piece : withEnds (piece, pieces.back().end, piece.end));

    const auto first = pieces.front().start;
    pieces.back() = withEnds (pieces.back(), pieces.back().start, first);

    // Ends that were moved may have left nothing of what lay between them.
    dropShort (whole, shortest);

    if (! pieces.empty())
        pieces.back() = withEnds (pieces.back(), pieces.back().start, pieces.front().start);

    return pieces;
}

/** The strokes that follow each other from one on, until they are back at its start. */
std::vector<Stroke> chainFrom (std::size_t first, const std::vector<Stroke>& open, const Ends& ends,
                               std::vector<bool>& isUsed)
{
    std::vector<Stroke> chain;

    // At each end exactly two meet, so the way leads back.
    for (auto begin = 2 * first; ! isUsed[begin / 2]; begin = ends.partnerOf (begin ^ 1u))
    {
        isUsed[begin / 2] = true;
        chain.push_back (begin % 2 == 0 ? open[begin / 2] : reversed (open[begin / 2]));
    }

    return chain;
}
} // namespace

bool isWithinReach (const Eigen::Vector2d& place)
{
    constexpr double farthest = 1000; // m
    return std::abs (place.x()) <= farthest && std::abs (place.y()) <= farthest;
}

void DrawnStrokes::add (Stroke stroke)
{
    pieces += stroke.pieces.size();

    if (pieces > maximumStrokePieces)
        throw InputError (source, "has more than " + std::to_string (maximumStrokePieces) + " lines and arcs");

    for (const auto& piece : stroke.pieces)
        if (! isWithinReach (piece.start) || ! isWithinReach (piece.end))
            throw InputError (stroke.name, "has a place farther than 1000 m from the origin");

    if (! stroke.pieces.empty())
        list.push_back (std::move (stroke));
}

void transform (std::vector<PathPiece>& pieces, const Eigen::Affine2d& map)
{
    for (auto& piece : pieces)
    {
        for (auto* place : { &piece.start, &piece.end, &piece.centre })
            *place = map * *place;

        for (auto* direction : { &piece.cosine, &piece.sine })
            *direction = map.linear() * *direction;
    }
}

std::vector<ClosedPath> joinedStrokes (std::vector<Stroke> strokes, double tolerance)
{
    std::vector<std::pair<std::size_t, ClosedPath>> paths; ///< By what was drawn first of them.
    std::vector<Stroke> open;
    std::vector<std::size_t> drawn; ///< Which of the strokes the open ones are.

    const auto shortest = tolerance / 10;

    for (std::size_t i = 0; i < strokes.size(); ++i)
    {
        dropShort (strokes[i], shortest);

        if (strokes[i].pieces.empty())
            continue;

        if ((startOf (strokes[i]) - endOf (strokes[i])).norm() <= tolerance)
        {
            paths.emplace_back (i, closedPath ({ strokes[i] }, shortest));
            continue;
        }

        open.push_back (std::move (strokes[i]));
        drawn.push_back (i);
    }

    const Ends ends (open, tolerance);
    std::vector<bool> isUsed (open.size());

    // Every end has to have one partner, so that no chain stops on its way.
    for (std::size_t end = 0; end < 2 * open.size(); ++end)
        ends.partnerOf (end);

    for (std::size_t first = 0; first < open.size(); ++first)
        if (! isUsed[first])
            paths.emplace_back (drawn[first], closedPath (chainFrom (first, open, ends, isUsed), shortest));

    std::sort (paths.begin(), paths.end(), [] (const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<ClosedPath> sorted;

    for (auto& [index, path] : paths)
        if (! path.empty())
            sorted.push_back (std::move (path));

    return sorted;
}
} // namespace antinode
