#include "Support/BrokenOutlines.h"
#include "Support/ErrorText.h"

#include <antinode_outline/PathBuilder.h>
#include <antinode_outline/PathSweep.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace antinode;

namespace
{
std::string checked (const Outline& outline, const std::vector<OutlinePart>& parts)
{
    return errorText (
        [&]
        {
            checkOutline (outline, "plate");
            checkParts (outline, parts);
        });
}

/** Some paths through places on a coarse grid, so that corners meet, lines lie on each other and arcs touch; without
   pieces of no length. */
std::vector<ClosedPath> randomPaths (std::mt19937& random)
{
    const auto number = [&] (int last) { return static_cast<int> (random() % static_cast<unsigned> (last + 1)); };
    const auto place = [&]() -> Eigen::Vector2d { return Eigen::Vector2d (number (16), number (16)) / 16; };
    std::vector<ClosedPath> paths;

    for (auto k = number (2); k >= 0; --k)
    {
        const auto first = place();
        PathBuilder path (first);

        for (auto i = 2 + number (3); i >= 0; --i)
        {
            const auto end = i == 0 ? first : place();
            number (1) == 0 ? path.lineTo (end, 0) : path.arcTo (end, number (16) / 8.0 - 1, 0);
        }

        if (auto closed = path.close(); closed.size() > 1)
            paths.push_back (std::move (closed));
    }

    return paths;
}

/** Whether any two pieces meet, by asking each pair. */
bool anyMeet (const std::vector<ClosedPath>& paths, double tolerance)
{
    std::vector<const PathPiece*> pieces;

    for (const auto& path : paths)
        for (const auto& piece : path)
            pieces.push_back (&piece);

    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (meeting (*pieces[i], *pieces[j], tolerance)
                || (pieces[i]->start - pieces[j]->start).norm() <= tolerance)
                return true;

    return false;
}

bool hasShortPiece (const std::vector<ClosedPath>& paths)
{
    for (const auto& path : paths)
        for (const auto& piece : path)
            if ((piece.end - piece.start).norm() < 1e-5)
                return true;

    return false;
}

/** The smallest path around the first place of another, by counting crossings; -1: none. */
int pathAround (const std::vector<ClosedPath>& paths, std::size_t path)
{
    const auto& place = paths[path].front().start;
    auto innermost = -1;
    auto area = 1e300;

    for (std::size_t other = 0; other < paths.size(); ++other)
        if (other != path && Outline { { paths[other] } }.contains (place.x(), place.y())
            && std::abs (signedArea (paths[other])) < area)
        {
            area = std::abs (signedArea (paths[other]));
            innermost = static_cast<int> (other);
        }

    return innermost;
}
} // namespace

TEST_CASE ("Five hundred broken outlines have one sentence each, and none before they were broken", "[outline]")
{
    for (const auto& broken : test::brokenOutlines (500, 18))
    {
        INFO (broken.fault);
        CHECK (checked (broken.whole, broken.wholeParts).empty());
        const auto sentence = checked (broken.outline, broken.parts);
        CHECK_THAT (sentence, Catch::Contains (broken.words) && Catch::Contains ("; allowed: "));
        CHECK (sentence.find ('\n') == std::string::npos);
    }
}

TEST_CASE ("A sweep over paths finds what asking every pair of pieces finds, and which path lies in which", "[outline]")
{
    std::mt19937 random (7);
    int meet = 0, apart = 0;

    for (int i = 0; i < 4000; ++i)
    {
        const auto paths = randomPaths (random);

        if (hasShortPiece (paths))
            continue;

        const auto nesting = nestingOf (paths, 1e-9);
        const auto doMeet = anyMeet (paths, 1e-9);
        CHECK (nesting.conflict.has_value() == doMeet);
        ++(doMeet ? meet : apart);

        for (std::size_t path = 0; ! doMeet && path < paths.size(); ++path)
            CHECK (static_cast<int> (nesting.around[path].value_or (std::size_t (-1))) == pathAround (paths, path));
    }

    CHECK (meet > 1000);
    CHECK (apart > 300);
}

TEST_CASE ("Pieces that share an end meet only where they run back along each other or cross again", "[outline]")
{
    const auto line = [] (Eigen::Vector2d a, Eigen::Vector2d b) { return linePiece (a, b, 0); };
    CHECK_FALSE (meeting (line ({ 0, 0 }, { 1, 0 }), line ({ 1, 0 }, { 2, 0 }), 1e-9));
    CHECK_FALSE (meeting (line ({ 0, 0 }, { 1, 0 }), line ({ 1, 0 }, { 0, 1e-3 }), 1e-9));
    CHECK (meeting (line ({ 0, 0 }, { 1, 0 }), line ({ 1, 0 }, { 0.5, 0 }), 1e-9));
    PathBuilder arc ({ 0, 0 });
    arc.arcTo ({ 1, 0 }, 0.3, 0); // Below the line that joins its ends, and both again at a slope.
    CHECK_FALSE (meeting (arc.close().front(), line ({ 1, 0 }, { 0, 0 }), 1e-9));
    CHECK (meeting (arc.close().front(), line ({ 0, 0 }, { 1, -0.3 }), 1e-9));
}

TEST_CASE ("A ceramic may be flush with an edge of its plate and with its neighbour", "[outline]")
{
    const Outline plate { { rectanglePath ({ 0.1, 0.05 }, { 0.2, 0.1 }, 0, {}, 0) } };
    const auto ceramic = [] (double x, double y) {
        return OutlinePart { "ceramic", { { rectanglePath ({ x, y }, { 0.02, 0.02 }, 0, {}, 0) } } };
    };
    CHECK_NOTHROW (checkParts (plate, { ceramic (0.01, 0.01), ceramic (0.03, 0.01), ceramic (0.01, 0.09) }));
    CHECK_THROWS (checkParts (plate, { ceramic (0.0099, 0.01) }));
    CHECK_THROWS (checkParts (plate, { ceramic (0.03, 0.01), ceramic (0.0499, 0.01) }));
    // A disc within the hole of a ring.
    const OutlinePart ring { "ring", { { circlePath ({ 0.1, 0.05 }, 0.03, 0), circlePath ({ 0.1, 0.05 }, 0.02, 1) } } };
    CHECK_NOTHROW (checkParts (plate, { ring, { "disc", { { circlePath ({ 0.1, 0.05 }, 0.01, 0) } } } }));
    CHECK_THROWS (checkParts (plate, { ring, { "disc", { { circlePath ({ 0.125, 0.05 }, 0.002, 0) } } } }));
}
