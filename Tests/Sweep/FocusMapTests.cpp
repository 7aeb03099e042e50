#include "Support/ErrorText.h"

#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/Prediction.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_sweep/FocusMap.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
constexpr Playback playback { Reconstruction::bandLimited, 192000 };

WideModel wideOf (const std::string& device, const std::vector<std::string>& assignments)
{
    const auto description = loadDevice (device, assignments);
    const auto known = solveDevice (description, {}, false);
    return solveWide (description, known, 1.5 * known.frequencyHz (known.modes() - 1), false);
}

/** Every place by a design of its own. */
void checkAgainstDesigns (const WideModel& wide, const FocusDescription& focus, const FocusMap& map)
{
    for (const auto& place : map.places)
    {
        INFO (place.x << ", " << place.y);
        REQUIRE (place.error.empty());
        const auto design = designWithin (wide, movedTo (focus, place.x, place.y), playback, DesignExtent::playable);
        const auto& model = wide.model;
        const auto velocities =
            modalVelocities (model, predictStates (model, design.program, design.moments.front().time));
        const auto score = scoreField (model.surface, model.shapes * velocities, design.moments.front().target.field);
        CHECK (place.controlled == static_cast<int> (design.controlledModes.size()));
        CHECK (place.captured == Approx (design.captured).epsilon (1e-9));
        // The norm is summed on a finer common grid of times, which changes the least norm by a few 1e-4.
        CHECK (place.peakVoltage == Approx (peakVoltage (design)).epsilon (3e-3));
        CHECK (place.vScore == Approx (score.vScore).epsilon (1e-4));
        CHECK (place.fieldError == Approx (score.fieldError).epsilon (1e-2).margin (1e-4));
        CHECK (place.spillOver == Approx (spillOverShare (wide, velocities)).epsilon (2e-2).margin (1e-5));
    }
}
} // namespace

TEST_CASE ("A map of a line says what a design at each place says", "[sweep][map]")
{
    const auto wide = wideOf ("beam", {});
    const auto focus = loadFocus ("demonstrator", {});
    MapOptions options;
    options.places = 7;
    const auto map = mapFocus (wide, focus, options);
    REQUIRE (map.places.size() == 7);
    CHECK (map.rows == 1);
    checkAgainstDesigns (wide, focus, map);
    CHECK (std::any_of (map.places.begin(), map.places.end(), [] (const auto& place) { return place.isShared; }));
}

TEST_CASE ("A map of a plate says what a design at each place says, the number of modes being weighed", "[sweep][map]")
{
    const auto wide = wideOf ("aluminium-200x120", { "device.modes.count=40" });
    const auto focus = loadFocus ("aluminium-centre", { "focus.targets.0.width_mm=40" });
    MapOptions options;
    options.places = 6;
    const auto map = mapFocus (wide, focus, options);
    CHECK (map.columns * map.rows == static_cast<Eigen::Index> (map.places.size()));
    CHECK (map.columns > map.rows);
    checkAgainstDesigns (wide, focus, map);
    CHECK (std::all_of (map.places.begin(), map.places.end(), [] (const auto& place) { return place.isShared; }));
}

TEST_CASE ("Felt contrast of a map is that of a render with all modes", "[sweep][map]")
{
    const auto wide = wideOf ("beam", {});
    const auto focus = loadFocus ("demonstrator", {});
    MapOptions options;
    options.places = 3;
    options.threshold = findSkinThreshold ({});
    const auto map = mapFocus (wide, focus, options);

    for (const auto& place : map.places)
    {
        RenderOptions render;
        render.threshold = options.threshold;
        const auto played = renderFocus (
            wide, designWithin (wide, movedTo (focus, place.x, place.y), playback, DesignExtent::playable), render);
        // Persons differ by 10 dB; the modes that are left out add less than a tenth of one.
        CHECK (place.contrast.value() == Approx (played.felt->contrast().value()).margin (0.1));
    }
}

TEST_CASE ("Felt contrast of a map of a plate is that of a render with all modes on all points", "[sweep][map]")
{
    const auto wide = wideOf ("aluminium-200x120", { "device.modes.count=40" });
    const auto focus = loadFocus ("aluminium-centre", { "focus.targets.0.width_mm=40" });
    MapOptions options;
    options.places = 2;
    options.threshold = findSkinThreshold ({});
    const auto map = mapFocus (wide, focus, options);

    for (const auto& place : map.places)
    {
        RenderOptions render;
        render.threshold = options.threshold;
        const auto design = designWithin (wide, movedTo (focus, place.x, place.y), playback, DesignExtent::playable);
        const auto played = renderFocus (wide, design, render);
        // A map looks at places that lie twice as far apart, and misses the top of the largest wave by some tenths.
        CHECK (place.contrast.value() == Approx (played.felt->contrast().value()).margin (0.5));
    }
}

TEST_CASE ("Places that cannot be designed for say why, and a map of nothing else is refused", "[sweep][map]")
{
    const auto wide = wideOf ("beam", {});
    MapOptions options;
    options.places = 3;
    auto two = loadFocus ("demonstrator", {});
    two.targets.push_back (two.targets.front());
    two.targets.back().x += 0.05;
    const auto map = mapFocus (wide, two, options);
    CHECK (map.places.front().error.empty());
    CHECK_THAT (map.places.back().error, Catch::Contains ("outside the surface"));

    const auto weak = loadFocus ("demonstrator", { "focus.allocation.voltage_limit_V=0.01" });
    CHECK_THAT (errorText ([&] { mapFocus (wide, weak, options); }), Catch::StartsWith ("map: no place"));
}
