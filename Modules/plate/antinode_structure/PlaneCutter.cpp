#include "PlaneCutter.h"

#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
/** Computed once, for all threads; entries of a map stay where they are. */
const Quadrature& rule (int points)
{
    static std::mutex mutex;
    static std::map<int, Quadrature> rules;
    const std::lock_guard lock (mutex);
    const auto [entry, isNew] = rules.try_emplace (points);

    if (isNew)
        entry->second = gaussLegendre (points, 1);

    return entry->second;
}

double yAt (const PathPiece& piece, double x)
{
    return piece.at (piece.parameterAt (PlaneAxis::x, x)).y();
}

double xAt (const PathPiece& piece, double y)
{
    return piece.at (piece.parameterAt (PlaneAxis::y, y)).x();
}

/** The heights at which a straight line meets a piece. */
void addMeetings (std::vector<double>& heights, const PathPiece& line, const PathPiece& piece)
{
    const Eigen::Vector2d normal (-line.cosine.y(), line.cosine.x());
    const auto offset = normal.dot (line.start - piece.centre);
    const auto a = normal.dot (piece.cosine), b = normal.dot (piece.sine);

    if (piece.isStraight)
    {
        if (a != 0)
            heights.push_back (piece.at (offset / a).y());

        return;
    }

    const auto radius = std::hypot (a, b);

    if (std::abs (offset) >= radius)
        return;

    for (const auto sign : { -1, 1 })
        heights.push_back (piece.at (std::atan2 (b, a) + sign * std::acos (offset / radius)).y());
}

/** The pieces of a cell's boundaries, strip by strip. */
class CellCutting
{
public:
    CellCutting (const std::vector<const Outline*>& outlinesToUse, const std::vector<PathPiece>& linesToUse,
                 const CellExtent& cellToCut, int degree)
        : outlines (outlinesToUse), lines (linesToUse), cell (cellToCut), along (degree + 1)
    {
    }

    CellPoints points()
    {
        const auto heights = criticalHeights();

        for (std::size_t i = 0; i + 1 < heights.size(); ++i)
            addStrip (heights[i], heights[i + 1]);

        return std::move (result);
    }

private:
    struct Crossing
    {
        double x = 0;
        const PathPiece* piece = nullptr;
        std::size_t outline = 0; ///< Beyond all of them: a line.
    };

    void addHeights (std::vector<double>& heights, const PathPiece& piece) const
    {
        if (piece.largest (PlaneAxis::x) < cell.left || piece.least (PlaneAxis::x) > cell.right
            || piece.largest (PlaneAxis::y) < cell.bottom || piece.least (PlaneAxis::y) > cell.top)
            return;

        heights.push_back (piece.start.y());
        heights.push_back (piece.end.y());

        for (const auto x : { cell.left, cell.right })
            if (x > piece.least (PlaneAxis::x) && x < piece.largest (PlaneAxis::x))
                heights.push_back (yAt (piece, x));

        for (const auto& line : lines)
            addMeetings (heights, line, piece);
    }

    std::vector<double> criticalHeights() const
    {
        std::vector<double> heights { cell.bottom, cell.top };

        for (const auto* outline : outlines)
            for (const auto& path : outline->paths)
                for (const auto& piece : path)
                    addHeights (heights, piece);

        for (const auto& line : lines)
            addHeights (heights, line);

        std::erase_if (heights, [&] (double y) { return ! (y >= cell.bottom && y <= cell.top); });
        std::sort (heights.begin(), heights.end());
        return heights;
    }

    std::vector<Crossing> crossingsAt (double y) const
    {
        std::vector<Crossing> all;

        for (std::size_t i = 0; i < outlines.size(); ++i)
            for (const auto& path : outlines[i]->paths)
                for (const auto& piece : path)
                    if (const auto x = piece.crossing (PlaneAxis::y, y))
                        all.push_back ({ *x, &piece, i });

        for (const auto& line : lines)
            if (const auto x = line.crossing (PlaneAxis::y, y))
                all.push_back ({ *x, &line, outlines.size() });

        std::sort (all.begin(), all.end(), [] (const Crossing& a, const Crossing& b) { return a.x < b.x; });
        return all;
    }

    void addStrip (double low, double high)
    {
        // Thinner strips are rounding.
        if (high - low <= 1e-14 * (cell.top - cell.bottom))
            return;

        const auto middle = (low + high) / 2;
        std::vector<bool> isInside (outlines.size(), false);
        const PathPiece* left = nullptr;
        auto begin = cell.left;

        for (const auto& crossing : crossingsAt (middle))
        {
            const auto end = std::clamp (crossing.x, cell.left, cell.right);

            if (end > begin)
            {
                const auto isWithin = crossing.x < cell.right;
                addPart ({ low, high, left, isWithin ? crossing.piece : nullptr }, isInside);
                begin = end;
                left = crossing.piece;
            }
            else if (crossing.x >= cell.left)
                left = crossing.piece;

            if (crossing.outline < outlines.size())
                isInside[crossing.outline] = ! isInside[crossing.outline];
        }

        if (begin < cell.right)
            addPart ({ low, high, left, nullptr }, isInside);
    }

    /** What lies in a strip between two pieces, or sides of the cell. */
    struct Part
    {
        double low = 0, high = 0;
        const PathPiece *left = nullptr, *right = nullptr;
    };

    std::size_t sectionOf (const std::vector<bool>& isInside)
    {
        const std::vector<bool> patches (isInside.begin() + 1, isInside.end());
        const auto found = std::find (result.sections.begin(), result.sections.end(), patches);

        if (found == result.sections.end())
            result.sections.push_back (patches);

        return static_cast<std::size_t> (std::find (result.sections.begin(), result.sections.end(), patches)
                                         - result.sections.begin());
    }

    /** The arc along which the strip is measured out by its angle, so that the ends of its other coordinate do no harm:
       where both sides are arcs the one that is flatter. */
    static const PathPiece* guide (const Part& part)
    {
        const PathPiece* best = nullptr;
        double least = 2;

        for (const auto* piece : { part.left, part.right })
        {
            if (piece == nullptr || piece->isStraight)
                continue;

            for (const auto y : { part.low, part.high })
            {
                const auto derivative = piece->derivative (piece->parameterAt (PlaneAxis::y, y));

                if (const auto steepness = std::abs (derivative.y()) / derivative.norm(); steepness < least)
                {
                    least = steepness;
                    best = piece;
                }
            }
        }

        return best;
    }

    void addPart (const Part& part, const std::vector<bool>& isInside)
    {
        if (! isInside[0])
            return;

        const auto section = sectionOf (isInside);
        const auto isSlanted = part.left != nullptr || part.right != nullptr;
        const auto* const arc = guide (part);

        if (arc == nullptr)
        {
            const auto& across = rule (isSlanted ? along + along / 2 : along);

            for (Eigen::Index i = 0; i < across.nodes.size(); ++i)
                addRow (part, part.low + (part.high - part.low) * across.nodes[i],
                        (part.high - part.low) * across.weights[i], section);

            return;
        }

        const auto from = arc->parameterAt (PlaneAxis::y, part.low), to = arc->parameterAt (PlaneAxis::y, part.high);
        const auto& across = rule (along + along / 2 + static_cast<int> (std::ceil (6 * std::abs (to - from))));

        for (Eigen::Index i = 0; i < across.nodes.size(); ++i)
        {
            const auto angle = from + (to - from) * across.nodes[i];
            addRow (part, arc->at (angle).y(), std::abs (arc->derivative (angle).y() * (to - from)) * across.weights[i],
                    section);
        }
    }

    void addRow (const Part& part, double y, double weight, std::size_t section)
    {
        const auto left = part.left == nullptr ? cell.left : std::max (xAt (*part.left, y), cell.left);
        const auto right = part.right == nullptr ? cell.right : std::min (xAt (*part.right, y), cell.right);

        if (! (right > left))
            return;

        const auto& row = rule (along);

        for (Eigen::Index i = 0; i < row.nodes.size(); ++i)
        {
            result.places.emplace_back (left + (right - left) * row.nodes[i], y);
            result.weights.push_back (weight * (right - left) * row.weights[i]);
            result.section.push_back (section);
        }
    }

    const std::vector<const Outline*>& outlines;
    const std::vector<PathPiece>& lines;
    CellExtent cell;
    int along;
    CellPoints result;
};
} // namespace

PlaneCutter::PlaneCutter (const Outline& plate, std::vector<const Outline*> patches) : outlines { &plate }
{
    outlines.insert (outlines.end(), patches.begin(), patches.end());
}

bool PlaneCutter::cuts (const CellExtent& cell) const
{
    for (const auto* outline : outlines)
        for (const auto& path : outline->paths)
            for (const auto& piece : path)
                if (passesThrough (piece, cell))
                    return true;

    return false;
}

CellPoints PlaneCutter::points (const CellExtent& cell, int degree, const std::vector<PathPiece>& lines) const
{
    return CellCutting (outlines, lines, cell, degree).points();
}

bool passesThrough (const PathPiece& piece, const CellExtent& cell)
{
    const auto left = std::max (piece.least (PlaneAxis::x), cell.left);
    const auto right = std::min (piece.largest (PlaneAxis::x), cell.right);

    if (piece.largest (PlaneAxis::y) <= cell.bottom || piece.least (PlaneAxis::y) >= cell.top || left > right)
        return false;

    // Upright pieces have all their heights at one x.
    if (piece.least (PlaneAxis::x) == piece.largest (PlaneAxis::x))
        return piece.start.x() > cell.left && piece.start.x() < cell.right;

    if (left == right)
        return false;

    const auto [low, high] = std::minmax ({ yAt (piece, left), yAt (piece, right) });
    return high > cell.bottom && low < cell.top && (low != high || (low > cell.bottom && low < cell.top));
}
} // namespace antinode
