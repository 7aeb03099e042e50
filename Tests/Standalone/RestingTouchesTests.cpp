#include <Standalone/RestingTouches.h>

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

TEST_CASE ("touches rest only as a kind of finger, on the surface and beside each other")
{
    RestingTouches touches;
    const auto surface = someSurface();
    CHECK_FALSE (touches.rest (1, 0.05, 0.05, surface));
    touches.setKind ("medium");
    CHECK (touches.rest (1, 0.05, 0.05, surface));
    CHECK_FALSE (touches.rest (2, 0.25, 0.05, surface));
    CHECK_FALSE (touches.rest (2, 0.055, 0.05, surface)); // Two contacts of 5 mm, 5 mm apart.
    CHECK (touches.rest (1, 0.055, 0.05, surface));       // The same one moves.
    CHECK (touches.rest (2, 0.1, 0.05, surface));
    CHECK (touches.count() == 2);
    touches.setKind ("firm");
    CHECK (touches.count() == 0);

    for (int i = 0; i < 30; ++i)
        touches.rest (i, 0.013 * (i % 15 + 1), i < 15 ? 0.03 : 0.07, surface);

    CHECK (touches.count() == RestingTouches::mostFingers);
}

TEST_CASE ("fingers are put down together, not too often, beside those of the focus, and lifted again")
{
    RestingTouches touches;
    touches.setKind ("light");
    const auto surface = someSurface();
    const std::vector own { builtInFinger ("firm", 0.02, 0.02) };
    CHECK_FALSE (touches.due (own, start));
    touches.rest (1, 0.05, 0.05, surface);
    touches.rest (2, 0.15, 0.05, surface);
    touches.rest (3, 0.021, 0.02, surface); // Over the focus's own one: waits.
    const auto first = touches.due (own, start);
    REQUIRE (first);
    REQUIRE (first->size() == 3);
    CHECK (first->front() == own.front());
    CHECK (first->at (1).name == "light");
    CHECK_FALSE (first->at (1).isKnown);
    CHECK_FALSE (touches.due (*first, start + 600ms)); // Nothing has changed.

    touches.lift (1);
    CHECK (touches.due (*first, start + 100ms) == std::nullopt);
    const auto second = touches.due (*first, start + 700ms);
    REQUIRE (second);
    REQUIRE (second->size() == 2);
    CHECK (second->at (1).x == 0.15);

    // The focus's own finger is lifted in the editor: now the third touch rests too.
    const std::vector<Finger> others { second->at (1) };
    const auto third = touches.due (others, start + 1400ms);
    REQUIRE (third);
    CHECK (third->size() == 2);
    CHECK (touches.allLifted (*third).value().empty());
    CHECK_FALSE (touches.allLifted ({}));
    CHECK (touches.count() == 0);
}
