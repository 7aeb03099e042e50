#include "OutlineChecks.h"

#include "PathSweep.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
// Shares of the outline's extent.
constexpr double touching = 1e-7;
constexpr double shortestPiece = 1e-6;
constexpr double shrinkage = 1e-5;   // of a part, so that it may be flush with something
constexpr double farthest = 1000;    // m from the origin
constexpr double leastExtent = 1e-6; // m

std::string inMillimetres (const Eigen::Vector2d& place)
{
    return "(" + inWords (1000 * place.x()) + ", " + inWords (1000 * place.y()) + ") mm";
}

/** The first path is the outer one, the others are holes that count from 1. */
std::string pathName (std::size_t path)
{
    return path == 0 ? "the outer path" : "hole " + std::to_string (path);
}

bool isBounded (const PathPiece& piece)
{
    // Of what is not a number no comparison is true.
    const auto isNear = [] (const Eigen::Vector2d& place)
    { return std::abs (place.x()) <= farthest && std::abs (place.y()) <= farthest; };
    return isNear (piece.start) && isNear (piece.end) && piece.centre.allFinite() && piece.cosine.allFinite()
           && piece.sine.allFinite() && std::isfinite (piece.from) && std::isfinite (piece.to);
}

void checkCounts (const Outline& outline, const std::string& name)
{
    std::size_t pieces = 0;

    for (const auto& path : outline.paths)
        pieces += path.size();

    if (pieces == 0)
        throw InputError (name, "has no line and no arc; allowed: one closed path or more");

    if (pieces > maximumPieces)
        throw InputError (name, "has " + std::to_string (pieces) + " lines and arcs; allowed: at most "
                                    + std::to_string (maximumPieces) + ", curves being arcs and not short lines");
}

void checkPieces (const ClosedPath& path, const std::string& name, const std::string& which)
{
    if (path.empty())
        throw InputError (name, which + " has no line and no arc; allowed: a closed path");

    for (const auto& piece : path)
        if (! isBounded (piece))
            throw InputError (name, which
                                        + " has a coordinate that is not a number or is too large; allowed: "
                                          "-1000 to 1000 m");
}

/** Whether two pieces are parts of one arc, which was cut where x or y turns back. */
bool areOfOneArc (const PathPiece& a, const PathPiece& b)
{
    return ! a.isStraight && ! b.isStraight && a.centre == b.centre && a.cosine == b.cosine && a.sine == b.sine;
}

void checkJoints (const ClosedPath& path, double extent, const std::string& name, const std::string& which)
{
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        const auto& piece = path[i];
        const auto& before = path[(i + path.size() - 1) % path.size()];
        const auto& next = path[(i + 1) % path.size()];
        const auto gap = std::max ({ (piece.end - next.start).norm(), (piece.at (piece.to) - next.start).norm(),
                                     (piece.at (piece.from) - piece.start).norm() });
        const auto length = (piece.end - piece.start).norm();

        if (piece.end != next.start || gap > touching * extent)
            throw InputError (name, which + " is open by " + inWords (1000 * gap) + " mm at "
                                        + inMillimetres (piece.end) + "; allowed: closed paths");

        if (length < shortestPiece * extent && ! areOfOneArc (before, piece) && ! areOfOneArc (piece, next))
            throw InputError (name, which + " has a line or arc of " + inWords (1000 * length) + " mm at "
                                        + inMillimetres (piece.start)
                                        + "; allowed: " + inWords (1000 * shortestPiece * extent) + " mm or longer");
    }
}

/** Whether all of a path lies on one straight line. */
bool isFlat (const ClosedPath& path, double tolerance)
{
    const auto& first = path.front().start;
    Eigen::Vector2d along = Eigen::Vector2d::Zero();

    for (const auto& piece : path)
        if ((piece.start - first).norm() > along.norm())
            along = piece.start - first;

    const Eigen::Vector2d across = Eigen::Vector2d (-along.y(), along.x()).normalized();
    return std::all_of (path.begin(), path.end(),
                        [&] (const PathPiece& piece)
                        {
                            const auto middle = piece.at ((piece.from + piece.to) / 2);
                            return std::abs (across.dot (piece.start - first)) <= tolerance
                                   && std::abs (across.dot (middle - first)) <= tolerance;
                        });
}

std::string sentenceOf (const PathConflict& conflict)
{
    const auto place = " at " + inMillimetres (conflict.place);

    if (conflict.path == conflict.other)
        return pathName (conflict.path) + " crosses or touches itself" + place + "; allowed: paths that do not";

    return pathName (conflict.path) + " and " + pathName (conflict.other) + " cross or touch" + place
           + "; allowed: holes within the outline and apart from each other";
}

void checkNesting (const PathNesting& nesting, const std::string& name)
{
    for (std::size_t path = 0; path < nesting.around.size(); ++path)
    {
        const auto around = nesting.around[path];

        if (path > 0 && ! around)
            throw InputError (name, pathName (path) + " lies outside the outer path; allowed: holes within it");

        if (around && *around > 0)
            throw InputError (name, pathName (path) + " lies in " + pathName (*around)
                                        + "; allowed: holes in the outer path only");

        if (path == 0 && around)
            throw InputError (name, "the outer path lies in a hole; allowed: holes within it");
    }
}

Outline shrunk (const Outline& outline)
{
    const auto extent = extentOf (outline);
    const Eigen::Vector2d centre = (extent.least + extent.largest) / 2;
    return moved (scaled (moved (outline, 0, -centre), 1 - shrinkage), 0, centre);
}

/** All paths of a plate and of the parts on it, and whose they are. */
struct PathsOfParts
{
    std::vector<ClosedPath> paths;
    std::vector<std::size_t> owner; ///< 0: the plate, else the number of the part from 1.
    std::vector<std::size_t> index; ///< Of the path within its owner's outline.

    void add (const Outline& outline, std::size_t whose)
    {
        for (std::size_t i = 0; i < outline.paths.size(); ++i)
        {
            paths.push_back (outline.paths[i]);
            owner.push_back (whose);
            index.push_back (i);
        }
    }
};

void checkApart (const PathsOfParts& all, const PathConflict& conflict, const std::vector<OutlinePart>& parts)
{
    const auto first = all.owner[conflict.path], second = all.owner[conflict.other];
    const auto place = " at " + inMillimetres (conflict.place);

    if (first == 0)
        throw InputError (parts[second - 1].name, "reaches across " + pathName (all.index[conflict.path])
                                                      + " of the plate" + place + "; allowed: within the plate");

    throw InputError (parts[second - 1].name,
                      "overlaps " + parts[first - 1].name + place + "; allowed: parts that lie side by side");
}

/** What lies around a part, or within it, where no paths cross. */
void checkPlaced (const PathsOfParts& all, const PathNesting& nesting, const std::vector<OutlinePart>& parts)
{
    for (std::size_t path = 0; path < all.paths.size(); ++path)
    {
        const auto around = nesting.around[path];
        const auto owner = all.owner[path];
        const auto isOuter = all.index[path] == 0;

        if (owner == 0 && around && all.owner[*around] > 0 && all.index[*around] == 0)
            throw InputError (parts[all.owner[*around] - 1].name,
                              "covers " + pathName (all.index[path]) + " of the plate; allowed: within the plate");

        if (owner == 0 || ! isOuter)
            continue;

        if (! around)
            throw InputError (parts[owner - 1].name, "lies outside the plate; allowed: within it");

        const auto host = all.owner[*around];
        const auto isInOuter = all.index[*around] == 0;

        if (host == 0 && ! isInOuter)
            throw InputError (parts[owner - 1].name,
                              "lies in " + pathName (all.index[*around]) + " of the plate; allowed: within the plate");

        if (host > 0 && isInOuter)
            throw InputError (parts[owner - 1].name,
                              "lies on " + parts[host - 1].name + "; allowed: parts that lie side by side");
    }
}
} // namespace

void checkOutline (const Outline& outline, const std::string& name)
{
    checkCounts (outline, name);

    for (std::size_t i = 0; i < outline.paths.size(); ++i)
        checkPieces (outline.paths[i], name, pathName (i));

    const auto extent = extentOf (outline).size().maxCoeff();

    if (extent < leastExtent)
        throw InputError (name, "is " + inWords (1000 * extent) + " mm large; allowed: 0.001 mm or larger");

    for (std::size_t i = 0; i < outline.paths.size(); ++i)
    {
        checkJoints (outline.paths[i], extent, name, pathName (i));

        if (isFlat (outline.paths[i], 10 * touching * extent))
            throw InputError (name, pathName (i) + " encloses no area; allowed: paths that go around something");
    }

    const auto nesting = nestingOf (outline.paths, touching * extent);

    if (nesting.conflict)
        throw InputError (name, sentenceOf (*nesting.conflict));

    checkNesting (nesting, name);
}

void checkParts (const Outline& plate, const std::vector<OutlinePart>& parts)
{
    PathsOfParts all;
    all.add (plate, 0);

    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        checkOutline (parts[i].outline, parts[i].name);
        all.add (shrunk (parts[i].outline), i + 1);
    }

    const auto nesting = nestingOf (all.paths, touching * extentOf (plate).size().minCoeff());

    if (nesting.conflict && all.owner[nesting.conflict->path] > 0 && parts.size() > 1)
        for (const auto& part : parts) // What is wrong with one alone is said first.
            checkParts (plate, { part });

    if (nesting.conflict)
        checkApart (all, *nesting.conflict, parts);

    checkPlaced (all, nesting, parts);
}
} // namespace antinode
