#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusPlaces.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

// A focus for a device that comes without one. Its places follow from the drawings by hand, its velocity from the
// design itself.

using namespace antinode;

namespace
{
constexpr Playback suitedPlayback { Reconstruction::bandLimited, 48000 };

nlohmann::json suitedDevice (const std::string& name)
{
    return loadDocument (LibraryKind::device, name);
}

ModalModel solvedFrom (const nlohmann::json& device)
{
    return solveDevice (readDevice (device, "device"), {}, true);
}

/** An own plate: 100 mm x 60 mm of glass on its edges, four ceramics at the left, and so a free area at the right. */
nlohmann::json ownPlate()
{
    auto plate = suitedDevice ("glass-148x210");
    plate["name"] = "own";
    plate["length_x_mm"] = 100;
    plate["length_y_mm"] = 60;
    auto ceramics = nlohmann::json::array();

    for (const auto& [x, y] : { std::pair (5, 5), { 5, 45 }, { 30, 5 }, { 30, 45 } })
    {
        auto ceramic = plate["ceramics"][0];
        ceramic["name"] = "C" + std::to_string (ceramics.size() + 1);
        ceramic["x_mm"] = x;
        ceramic["y_mm"] = y;
        ceramics.push_back (ceramic);
    }

    plate["ceramics"] = ceramics;
    return plate;
}
} // namespace

TEST_CASE ("The middle of the free area is that of the drawing")
{
    SECTION ("a plate with ceramics along its rim: its centre")
    {
        const auto place = middleOfFreeArea (solvedFrom (suitedDevice ("glass-148x210")));
        CHECK (1000 * place.x() == Approx (105).margin (1));
        CHECK (1000 * place.y() == Approx (74).margin (1));
    }

    // Its ceramics leave gaps of 29 mm at most, around -8.5 mm and 65 mm.
    SECTION ("a beam: the middle of the widest gap, of two the one next to the centre")
    {
        const auto place = middleOfFreeArea (solvedFrom (suitedDevice ("beam")));
        CHECK (1000 * place.x() == Approx (-8.5).margin (0.5));
    }

    // The largest circle between the edges at 0, 60 and 100 mm: of 30 mm, from x = 47.5 on to 70 mm; the centre is at
    // 50 mm.
    SECTION ("ceramics on one side: the other side")
    {
        const auto place = middleOfFreeArea (solvedFrom (ownPlate()));
        CHECK (1000 * place.x() > 50);
        CHECK (1000 * place.x() < 71);
        CHECK (1000 * place.y() == Approx (30).margin (1));
    }
}

TEST_CASE ("The distance to an edge counts holes")
{
    Surface line;
    line.xMinimum = -0.1;
    line.xMaximum = 0.1;
    CHECK (distanceToEdge (line, 0.07, 5) == Approx (0.03));
    const auto phone = solvedFrom (suitedDevice ("phone"));
    // The hole of 14 mm is at 128 mm, 50 mm.
    CHECK (distanceToEdge (phone.surface, 0.115, 0.05) == Approx (0.006).epsilon (1e-6));
    CHECK (distanceToEdge (phone.surface, 0.06, 0.03) == Approx (0.03).epsilon (1e-6));
}

TEST_CASE ("A device without a focus gets one that it can reach")
{
    for (const auto* const name : { "glass-148x210", "beam", "staple", "phone", "acrylic-buzzers", "round-table",
                                    "wood-box", "aluminium-200x120" })
    {
        const auto model = solvedFrom (suitedDevice (name));
        const auto focus = suitableFocus (model, suitedPlayback);
        INFO (name << ": " << 1000 * focus.targets[0].x << ", " << 1000 * focus.targets[0].y << " mm, "
                   << 1000 * focus.targets[0].width << " mm, " << 1000 * focus.targets[0].peakVelocity << " mm/s, "
                   << 1000 * focus.focusTime << " ms");
        REQUIRE (focus.targets.size() == 1);
        CHECK_FALSE (focus.modes.count);
        FocusDesign design;
        REQUIRE_NOTHROW (design = designFocus (model, focus, suitedPlayback, DesignExtent::playable));
        CHECK (design.captured >= 0.9);
        CHECK ((! design.limit || design.limit->share() <= 1 + 1e-6));
        CHECK (distanceToEdge (model.surface, focus.targets[0].x, focus.targets[0].y) >= focus.targets[0].width / 2);
    }
}

TEST_CASE ("A low limit asks for a slower focus, not for one that cannot be had")
{
    auto device = ownPlate();
    device["limits"]["voltage_V"] = 0.5;
    const auto model = solvedFrom (device);
    const auto focus = suitableFocus (model, suitedPlayback);
    CHECK (focus.targets[0].peakVelocity < 0.02);
    CHECK_NOTHROW (designFocus (model, focus, suitedPlayback, DesignExtent::playable));
    auto quicker = focus;
    quicker.targets[0].peakVelocity = 0.02; // Without the limit it would be that.
    CHECK_THROWS_AS (designFocus (model, quicker, suitedPlayback, DesignExtent::playable), LimitError);
}
