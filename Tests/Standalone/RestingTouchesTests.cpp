#include <Standalone/TouchInput.h>

#include <antinode_documents/FingerFile.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace std::chrono_literals;

namespace
{
Surface someSurface()
{
    Surface surface;
    surface.kind = SurfaceKind::plate;
    surface.xMaximum = 0.2;
    surface.yMaximum = 0.1;
    return surface;
}

constexpr RestingTouches::Time start { 100s };
} // namespace

TEST_CASE ("touches rest only as a kind of finger and on the surface")
{
    RestingTouches touches;
    const auto surface = someSurface();
    CHECK (touches.rest (1, 0.05, 0.05, surface) == RestResult::noKind);
    touches.setKind ("medium");
    CHECK (touches.rest (1, 0.05, 0.05, surface) == RestResult::taken);
    CHECK (touches.rest (2, 0.25, 0.05, surface) == RestResult::outsideSurface);
    CHECK (touches.count() == 1);
    touches.setKind ("firm");
    CHECK (touches.count() == 0);
}

TEST_CASE ("a touch on another one waits until that one leaves")
{
    RestingTouches touches;
    touches.setKind ("medium");
    const auto surface = someSurface();
    CHECK (touches.rest (2, 0.05, 0.05, surface) == RestResult::taken);
    CHECK (touches.rest (1, 0.055, 0.05, surface) == RestResult::taken); // Two contacts of 5 mm, 5 mm apart.
    const auto first = touches.due ({}, {}, surface, start).value();
    REQUIRE (first.size() == 1);
    CHECK (first[0].x == 0.05); // Who came first has the place.
    CHECK_FALSE (touches.due ({}, first, surface, start + 600ms));
    touches.lift (2);
    const auto second = touches.due ({}, first, surface, start + 1200ms).value();
    REQUIRE (second.size() == 1);
    CHECK (second[0].x == 0.055);
}

TEST_CASE ("as many touches rest as the focus has room for, and the others wait")
{
    RestingTouches touches;
    touches.setKind ("light");
    const auto surface = someSurface();

    for (int i = 0; i < 12; ++i)
        touches.rest (i, 0.013 * (i + 1), 0.03, surface);

    CHECK (touches.count() == 12);
    std::vector<Finger> own;

    for (int i = 0; i < 7; ++i)
        own.push_back (builtInFinger ("light", 0.013 * (i + 1), 0.07));

    const auto beside = touches.due (own, {}, surface, start).value();
    CHECK (beside.size() == maximumFingers - 7);
    CHECK (touches.due ({}, beside, surface, start + 600ms).value().size() == maximumFingers);
    touches.lift (0);
    touches.lift (1);
    touches.lift (2);
    const auto rest = touches.due ({}, {}, surface, start + 1200ms).value();
    CHECK (rest.size() == 9);
    CHECK (rest.back().x == Approx (0.013 * 12));

    // A device that is shorter has only those on its surface.
    auto shorter = surface;
    shorter.xMaximum = 0.1;
    CHECK (touches.due ({}, rest, shorter, start + 1800ms).value().size() == 4);
}

TEST_CASE ("a move of less than a two-hundredth of the surface is none")
{
    RestingTouches touches;
    touches.setKind ("medium");
    const auto surface = someSurface(); // 200 mm by 100 mm
    touches.rest (1, 0.05, 0.05, surface);
    const auto first = touches.due ({}, {}, surface, start).value();
    CHECK (touches.rest (1, 0.0509, 0.05, surface) == RestResult::taken);
    CHECK_FALSE (touches.due ({}, first, surface, start + 600ms));
    CHECK (touches.rest (1, 0.05, 0.0504, surface) == RestResult::taken);
    CHECK_FALSE (touches.due ({}, first, surface, start + 600ms));
    touches.rest (1, 0.05, 0.0506, surface);
    CHECK (touches.due ({}, first, surface, start + 600ms).value()[0].y == 0.0506);

    auto line = surface;
    line.kind = SurfaceKind::line;
    line.yMaximum = 0;
    touches.rest (2, 0.1, 0, line);
    touches.rest (2, 0.1009, 0, line);
    CHECK (touches.due ({}, {}, line, start + 1200ms).value().back().x == 0.1);
}

TEST_CASE ("fingers are put down together, not too often, beside those of the focus, and lifted again")
{
    RestingTouches touches;
    touches.setKind ("light");
    const auto surface = someSurface();
    const std::vector own { builtInFinger ("firm", 0.02, 0.02) };
    CHECK_FALSE (touches.due (own, {}, surface, start));
    touches.rest (1, 0.05, 0.05, surface);
    touches.rest (2, 0.15, 0.05, surface);
    touches.rest (3, 0.021, 0.02, surface); // Over the focus's own one: waits.
    const auto first = touches.due (own, {}, surface, start).value();
    REQUIRE (first.size() == 2);
    CHECK (first[0].name == "light");
    CHECK_FALSE (first[0].isKnown);
    CHECK_FALSE (touches.due (own, first, surface, start + 600ms)); // Nothing has changed.

    touches.lift (1);
    CHECK (touches.due (own, first, surface, start + 100ms) == std::nullopt);
    const auto second = touches.due (own, first, surface, start + 700ms).value();
    REQUIRE (second.size() == 1);
    CHECK (second[0].x == 0.15);

    // The focus's own finger is lifted in the editor: now the third touch rests too.
    CHECK (touches.due ({}, second, surface, start + 1400ms).value().size() == 2);

    // Another focus was loaded: none of them is on the surface.
    CHECK (touches.due ({}, {}, surface, start + 2100ms).value().size() == 2);
}
