#include <antinode_outline/PathBuilder.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using std::numbers::pi;

TEST_CASE ("Shapes have their areas, and holes take theirs off", "[outline]")
{
    CHECK (areaOf ({ { circlePath ({ 3, -2 }, 2, 0) } }) == Approx (4 * pi).epsilon (1e-13));
    CHECK (areaOf ({ { ellipsePath ({ 1, 1 }, { 3, 0.5 }, 0.7, 0) } }) == Approx (1.5 * pi).epsilon (1e-13));
    CHECK (areaOf ({ { circlePath ({ 0, 0 }, 2, 0), circlePath ({ 0.3, 0 }, 1, 1) } })
           == Approx (3 * pi).epsilon (1e-13));
    const auto rounded = rectanglePath ({ 5, 5 }, { 4, 2 }, 0.3, { 0.5, 0, 0.25, 1 }, 0);
    const auto corners = (1 - pi / 4) * (0.25 + 0.0625 + 1);
    CHECK (signedArea (rounded) == Approx (8 - corners).epsilon (1e-13));
    CHECK (signedArea (polygonPath ({ { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0.5, 0.5 }, { 0.5, 1 }, { 0, 1 } }, 0))
           == Approx (0.75).epsilon (1e-13));
}

TEST_CASE ("An arc is given by its ends and a bulge, as in drawings", "[outline]")
{
    PathBuilder path ({ 1, 0 });
    path.arcTo ({ -1, 0 }, 1, 0); // Half a circle, counter-clockwise.
    path.arcTo ({ 0, -1 }, std::tan (pi / 8), 0);
    path.lineTo ({ 1, 0 }, 1);
    const Outline outline { { path.close() } };
    CHECK (areaOf (outline) == Approx (3 * pi / 4 + 0.5).epsilon (1e-13));
    CHECK (outline.contains (0, 0.99));
    CHECK_FALSE (outline.contains (0.6, -0.6));
    CHECK (lengthOfEdge (outline, 0) == Approx (1.5 * pi).epsilon (1e-13));
    CHECK (lengthOfEdge (outline, 1) == Approx (std::sqrt (2)).epsilon (1e-13));
}

TEST_CASE ("What lies inside is what an even number of crossings says, on every row", "[outline]")
{
    const Outline ring { { circlePath ({ 0, 0 }, 1, 0), circlePath ({ 0, 0 }, 0.5, 1) } };

    for (double y = -1.25; y <= 1.25; y += 0.125)
    {
        CHECK (crossings (ring, PlaneAxis::y, y).size() % 2 == 0);

        for (double x = -1.2; x <= 1.2; x += 0.1)
        {
            const auto radius = std::hypot (x, y);

            if (std::abs (radius - 1) > 1e-9 && std::abs (radius - 0.5) > 1e-9)
                CHECK (ring.contains (x, y) == (radius > 0.5 && radius < 1));
        }
    }
}

TEST_CASE ("Moved outlines hold the moved places", "[outline]")
{
    const Outline outline { { rectanglePath ({ 1, 0 }, { 2, 1 }, 0, { 0.2, 0.2, 0, 0 }, 0),
                              ellipsePath ({ 1, 0 }, { 0.4, 0.2 }, 0, 4) } };
    const auto turned = moved (outline, 1.1, { -3, 2 });
    CHECK (areaOf (turned) == Approx (areaOf (outline)).epsilon (1e-13));
    CHECK (areaOf (scaled (outline, 3)) == Approx (9 * areaOf (outline)).epsilon (1e-13));

    for (double x = -0.05; x < 2.1; x += 0.1)
        for (double y = -0.55; y < 0.6; y += 0.1)
            CHECK (turned.contains (-3 + std::cos (1.1) * x - std::sin (1.1) * y,
                                    2 + std::sin (1.1) * x + std::cos (1.1) * y)
                   == outline.contains (x, y));
}

TEST_CASE ("The distance to the boundary is that to the nearest line or arc", "[outline]")
{
    const Outline ring { { circlePath ({ 0, 0 }, 1, 0), circlePath ({ 0, 0 }, 0.5, 1) } };
    CHECK (distanceToBoundary (ring, 0.6, 0) == Approx (0.1).epsilon (1e-6));
    CHECK (distanceToBoundary (ring, 0.3, 0.4) == Approx (0).margin (1e-6));
    CHECK (distanceToBoundary ({ { polygonPath ({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, 0) } }, 1, 1)
           == Approx (std::sqrt (0.5)).epsilon (1e-6));
}
