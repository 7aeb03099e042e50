#include "BrokenOutlines.h"

#include <antinode_outline/PathBuilder.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace antinode::test
{
namespace
{
using std::numbers::pi;

/** Numbers that are the same with every library. */
class Chance
{
public:
    explicit Chance (std::uint32_t seed) : engine (seed) {}

    double between (double low, double high)
    {
        return low + (high - low) * (static_cast<double> (engine()) / 4294967296.0);
    }
    int upTo (int last) { return static_cast<int> (engine() % static_cast<std::uint32_t> (last + 1)); }

private:
    std::mt19937 engine;
};

/** The corners of a plate of 160 to 240 mm about the origin, counter-clockwise; 70 mm about it are always inside. */
std::vector<Eigen::Vector2d> cornersOf (Chance& chance, int count)
{
    std::vector<Eigen::Vector2d> corners;

    for (int i = 0; i < count; ++i)
    {
        const auto angle = 2 * pi * (i + chance.between (-0.2, 0.2)) / count;
        corners.push_back (chance.between (0.1, 0.12) * Eigen::Vector2d (std::cos (angle), std::sin (angle)));
    }

    return corners;
}

/** Lines and arcs through corners. */
ClosedPath pathThrough (const std::vector<Eigen::Vector2d>& corners, Chance& chance)
{
    PathBuilder path (corners.front());

    for (std::size_t i = 1; i <= corners.size(); ++i)
    {
        const auto& end = corners[i % corners.size()];

        if (chance.upTo (1) == 0)
            path.lineTo (end, static_cast<int> (i));
        else
            path.arcTo (end, chance.between (-0.03, 0.2), static_cast<int> (i));
    }

    return path.close();
}

/** A hole within 30 mm of a place 35 mm from the origin. */
ClosedPath holeAt (double direction, Chance& chance)
{
    const Eigen::Vector2d centre = 0.035 * Eigen::Vector2d (std::cos (direction), std::sin (direction));
    const auto radius = chance.between (0.004, 0.02);

    switch (chance.upTo (2))
    {
        case 0:
            return circlePath (centre, radius, 0);
        case 1:
            return ellipsePath (centre, { radius, radius / 3 }, chance.between (0, pi), 0);
        default:
            return rectanglePath (centre, { radius, radius }, chance.between (0, pi), { 0, radius / 8, 0, radius / 4 },
                                  0);
    }
}

ClosedPath shifted (const ClosedPath& path, const Eigen::Vector2d& shift)
{
    return moved ({ { path } }, 0, shift).paths.front();
}

/** A plate with two holes on the x axis and two ceramics on the y axis, before it is broken. */
struct Example
{
    explicit Example (Chance& source) : chance (source)
    {
        corners = cornersOf (chance, 6 + chance.upTo (6));
        outline.paths = { pathThrough (corners, chance), holeAt (0, chance), holeAt (pi, chance) };
        parts = { { "ceramic 1", { { holeAt (pi / 2, chance) } } }, { "ceramic 2", { { holeAt (-pi / 2, chance) } } } };
    }

    Chance& chance;
    std::vector<Eigen::Vector2d> corners;
    Outline outline;
    std::vector<OutlinePart> parts;
    ClosedPath& outer() { return outline.paths.front(); }
    ClosedPath& hole() { return outline.paths[1]; }
    ClosedPath& ceramic() { return parts.front().outline.paths.front(); }
    Eigen::Vector2d farAway() const { return { 0.3, 0.05 }; }

    void useLines() { outer() = polygonPath (corners, 0); }
};

struct Fault
{
    const char* name;
    const char* words; ///< Of the sentence.
    void (*make) (Example&);
};

void cross (Example& example)
{
    // A corner moved to the other side of the plate.
    example.corners[2] *= -1.5;
    example.useLines();
}

void open (Example& example)
{
    example.useLines();
    example.outer().erase (example.outer().begin() + example.chance.upTo (3));
}

void leaveUnclosed (Example& example)
{
    PathBuilder path (example.corners.front());

    for (const auto& corner : example.corners)
        path.lineTo (corner, 0);

    example.outer() = path.close();
}

void flatten (Example& example)
{
    const Eigen::Vector2d middle (0.02, 0.01), end (0.04, 0.02);
    example.hole() = polygonPath ({ { 0, 0 }, middle, end }, 0);
}

void spoilNumber (Example& example)
{
    auto& path = example.outline.paths[static_cast<std::size_t> (example.chance.upTo (2))];
    auto& piece = path[static_cast<std::size_t> (example.chance.upTo (2))];
    const std::vector<double> values { std::numeric_limits<double>::quiet_NaN(),
                                       std::numeric_limits<double>::infinity(), -1e30, 1e4 };
    piece.start[example.chance.upTo (1)] = values[static_cast<std::size_t> (example.chance.upTo (3))];
}

void addSpike (Example& example)
{
    const Eigen::Vector2d corner = example.corners[1];
    example.corners.insert (example.corners.begin() + 2, { 1.3 * corner, corner });
    example.useLines();
}

void touchHoles (Example& example)
{
    const auto radius = example.chance.between (0.005, 0.02), angle = example.chance.between (0, pi);
    const Eigen::Vector2d place = radius * Eigen::Vector2d (std::cos (angle), std::sin (angle));
    example.outline.paths[1] = circlePath (place, radius, 0);
    example.outline.paths[2] = circlePath (-place, radius, 0);
}

void addManyCorners (Example& example)
{
    example.corners.clear();

    for (int i = 0; i < 100000; ++i)
        example.corners.push_back (0.1 * Eigen::Vector2d (std::cos (2e-5 * pi * i), std::sin (2e-5 * pi * i)));

    example.useLines();
}

void splitFinely (Example& example)
{
    example.corners.insert (example.corners.begin() + 1,
                            example.corners[1] * (1 + example.chance.between (0, 1e-7)) + Eigen::Vector2d (1e-9, 0));
    example.useLines();
}

void thin (Example& example)
{
    example.hole() = rectanglePath ({ 0, 0 }, { 0.04, 1e-9 }, example.chance.between (0, pi), {}, 0);
}

void addCeramicOnCeramic (Example& example)
{
    const auto extent = extentOf (example.parts[1].outline);
    const Eigen::Vector2d centre = (extent.least + extent.largest) / 2;
    example.parts[0].outline.paths = { circlePath (centre, example.chance.between (0.001, 0.03), 0) };
}

const std::vector<Fault> faults {
    { "self-crossing", "crosses or touches itself", cross },
    { "open", "is open by", open },
    { "not closed", "is open by", leaveUnclosed },
    { "zero area", "encloses no area", flatten },
    { "spike", "crosses or touches itself", addSpike },
    { "number", "not a number", spoilNumber },
    { "100 000 corners", "lines and arcs; allowed", addManyCorners },
    { "short line", "has a line or arc of", splitFinely },
    { "sliver", "of 1e-06 mm", thin },
    { "no path", "has no line", [] (Example& example) { example.outline.paths.clear(); } },
    { "empty path", "has no line", [] (Example& example) { example.hole().clear(); } },
    { "hole outside", "lies outside the outer path",
      [] (Example& example) { example.hole() = shifted (example.hole(), example.farAway()); } },
    { "holes touch", "cross or touch", touchHoles },
    { "hole across", "cross or touch",
      [] (Example& example) { example.hole() = circlePath (example.corners[1], 0.03, 0); } },
    { "hole in a hole", "lies in hole 1",
      [] (Example& example)
      {
          example.hole() = circlePath ({ 0, 0 }, 0.06, 0);
          example.parts.clear();
      } },
    { "drawn twice", "cross or touch", [] (Example& example) { example.outline.paths.push_back (example.hole()); } },
    { "ceramic across the outline", "reaches across the outer path",
      [] (Example& example) { example.ceramic() = circlePath (example.corners[1], 0.02, 0); } },
    { "ceramic outside", "lies outside the plate",
      [] (Example& example) { example.ceramic() = shifted (example.ceramic(), example.farAway()); } },
    { "ceramic across a hole", "reaches across hole 1",
      [] (Example& example)
      {
          const Eigen::Vector2d place = example.hole().front().start;
          example.parts = { { "ceramic 1", { { circlePath (place, 1e-3, 0) } } } };
      } },
    { "ceramic in a hole", "lies in hole 1",
      [] (Example& example)
      {
          const auto extent = extentOf ({ { example.hole() } });
          example.ceramic() = circlePath ((extent.least + extent.largest) / 2, 2e-4, 0);
      } },
    { "ceramic over a hole", "covers hole 1",
      [] (Example& example) {
          example.parts = { { "ceramic 1", { { circlePath ({ 0.035, 0 }, 0.03, 0) } } } };
      } },
    { "ceramic on another", "ceramic", addCeramicOnCeramic },
};
} // namespace

std::vector<BrokenOutline> brokenOutlines (int count, std::uint32_t seed)
{
    Chance chance (seed);
    std::vector<BrokenOutline> broken;

    for (int i = 0; i < count; ++i)
    {
        const auto& fault = faults[static_cast<std::size_t> (i) % faults.size()];
        Example example (chance);
        BrokenOutline made { fault.name, {}, example.outline, {}, example.parts, fault.words };
        fault.make (example);
        made.outline = example.outline;
        made.parts = example.parts;
        broken.push_back (made);
    }

    return broken;
}
} // namespace antinode::test
