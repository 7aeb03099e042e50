#include "PlateExamples.h"

#include <antinode_base/InputError.h>
#include <antinode_structure/PlacementSearch.h>
#include <antinode_structure/Placing.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** Ceramics of 10 mm on a line, a candidate every 5 mm. */
PlacementCandidates row (int count)
{
    PlacementCandidates candidates;

    for (int i = 0; i < count; ++i)
    {
        CeramicDescription ceramic;
        ceramic.x = 5e-3 * i;
        ceramic.sizeX = ceramic.sizeY = 10e-3;
        candidates.ceramics.push_back (ceramic);
    }

    candidates.participation = Eigen::MatrixXd::Ones (1, count);
    return candidates;
}

PlacingOptions fewCeramics()
{
    PlacingOptions options;
    options.count = 4;
    options.grid.step = 10e-3;
    options.grid.modes = 6;
    return options;
}
} // namespace

TEST_CASE ("Ceramics move step by step to where they cost least, and never overlap", "[structure][placement]")
{
    const auto candidates = row (40);
    std::atomic<int> asked { 0 };
    // Two wells, at 100 and 150 mm, so narrow steps lead there.
    const auto at = [&] (Eigen::Index candidate)
    { return candidates.ceramics[static_cast<std::size_t> (candidate)].x; };
    const auto cost = [&] (const std::vector<Eigen::Index>& pair)
    {
        ++asked;
        return std::pow (at (pair[0]) - 0.1, 2) + std::pow (at (pair[1]) - 0.15, 2);
    };
    const auto chosen = exchangeNeighbours (candidates, { 2, 36 }, cost);
    CHECK (chosen == std::vector<Eigen::Index> { 20, 30 });
    CHECK (asked > 20);

    // Both to the same place: they come to lie side by side.
    const auto together = [&] (const std::vector<Eigen::Index>& pair)
    { return std::abs (at (pair[0]) - 0.1) + std::abs (at (pair[1]) - 0.1); };
    const auto close = exchangeNeighbours (candidates, { 2, 36 }, together);
    CHECK_FALSE (candidates.overlap (close[0], close[1]));
    CHECK (close[1] - close[0] == 2);
}

TEST_CASE ("A device is solved with ceramics where they cost least", "[structure][placement]")
{
    const DeviceDescription device { "plate", "", barePlate ("SSSS", 0.12, 0.09) };
    const auto like = plateCeramic (0, 0, 20e-3, 20e-3);
    auto options = fewCeramics();
    const auto toLeft = [] (const std::vector<CeramicDescription>& ceramics)
    {
        double sum = 0;

        for (const auto& ceramic : ceramics)
            sum += ceramic.x;

        return sum;
    };
    const auto plain = placeCeramics (device, like, options);
    options.costOf = [&] (const PlacementCandidates& candidates) -> PlacementCost
    { return [&] (const auto& chosen) { return toLeft (chosenCeramics (candidates, chosen)); }; };
    const auto moved = placeCeramics (device, like, options);
    CHECK (toLeft (moved.ceramics) < toLeft (plain.ceramics));
    CHECK (moved.ceramics.size() == 4);
    CHECK (moved.controllability < plain.controllability);
    CHECK (moved.resolved);
}

TEST_CASE ("Ceramics stay outside of keep-out zones", "[structure][placement]")
{
    const DeviceDescription device { "plate", "", barePlate ("SSSS", 0.12, 0.09) };
    const auto like = plateCeramic (0, 0, 20e-3, 20e-3);
    auto options = fewCeramics();
    const auto all = placeCeramics (device, like, options);
    const auto& first = all.ceramics.front();
    const KeepOut zone { first.x + 1e-3, first.y + 1e-3, first.x + 19e-3, first.y + 19e-3 };
    options.keepOut = { zone };
    const auto placed = placeCeramics (device, like, options);
    CHECK (placed.candidates < all.candidates);

    for (const auto& ceramic : placed.ceramics)
        CHECK ((ceramic.x >= zone.right || ceramic.x + ceramic.sizeX <= zone.left || ceramic.y >= zone.top
                || ceramic.y + ceramic.sizeY <= zone.bottom));

    options.keepOut = { { -1, -1, 1, 1 } };
    CHECK_THROWS_AS (placeCeramics (device, like, options), InputError);
}
