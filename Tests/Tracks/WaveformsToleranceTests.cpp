#include "Support/SinePlate.h"

#include <antinode_focus/Detuning.h>
#include <antinode_render/PerformedWaveforms.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace antinode;

namespace
{
const SkinThreshold flat { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };

TouchedPoint touched (double x, double y)
{
    TouchedPoint point;
    point.x = x;
    point.y = y;
    point.finger = builtInFinger ("medium", x, y);
    return point;
}

/** A burst at one finger, nothing at another one. */
WaveformsDescription twoFingers()
{
    WaveformsDescription description;
    description.band = { 100, 800 };
    description.tracks.resize (1);
    description.tracks[0].point = touched (0.05, 0.06);
    description.tracks[0].events[0].signal = GaborSignal { 350, 0.01 };
    description.tracks[0].events[0].level.value = 1e-6;
    description.silent = { touched (0.15, 0.04) };
    return description;
}

constexpr ToleranceOptions drawn { { 0.01, 0.1, 0.05, 0.002 }, 4, 7 };

/** By responses at the points, against the whole surface sample by sample. */
void checkAgainstPlayed (const WaveformsDescription& description)
{
    const auto model = test::SinePlate().model (20);
    TrackSettings settings;
    settings.threshold = flat;
    const auto design = designTracks (model, description, settings);
    const auto tolerance = waveformsTolerance (model, design, flat, drawn, {});
    REQUIRE (tolerance.levels.rows() == drawn.draws);

    for (const std::uint64_t number : { 0, 3 })
    {
        const auto device = detuned (model, drawn.spread, drawSeed (drawn.seed, number));
        const auto played = performDesigned (device, design, flat);

        for (Eigen::Index p = 0; p < 2; ++p)
        {
            const auto row = static_cast<Eigen::Index> (number);
            // Levels are peaks between samples of another rate; errors are of the whole event.
            CHECK (tolerance.levels (row, p)
                   == Approx (played.felt.targets[static_cast<std::size_t> (p)].level).margin (0.1));
            CHECK (tolerance.suppression (row, p)
                   == Approx (played.scores.suppression (static_cast<std::size_t> (p))).margin (0.1));
        }
    }
}
} // namespace

TEST_CASE ("Voltages on devices that deviate answer as if each were played", "[tracks][render]")
{
    checkAgainstPlayed (twoFingers());
}

TEST_CASE ("A finger that no design knows of rests on devices that deviate, too", "[tracks][render]")
{
    auto description = twoFingers();
    description.silent[0].finger->isKnown = false;
    checkAgainstPlayed (description);
}

TEST_CASE ("On devices that deviate a point may move", "[tracks][render]")
{
    auto description = twoFingers();
    auto& point = description.tracks[0].point;
    point.finger.reset();
    point.path = { { 0, 0.05, 0.06 }, { 0.05, 0.055, 0.06 } };
    checkAgainstPlayed (description);
}

TEST_CASE ("The percentiles of devices that deviate stand in summary.json, all devices in a table", "[tracks][render]")
{
    const auto model = test::SinePlate().model (20);
    TrackSettings settings;
    settings.threshold = flat;
    const auto description = twoFingers();
    const auto tolerance = waveformsTolerance (model, designTracks (model, description, settings), flat, drawn, {});
    const auto json = toleranceToJson (description, tolerance);
    CHECK (json["draws"] == drawn.draws);
    CHECK (json["fingers"][1]["name"] == "silent finger 1");
    CHECK (json["fingers"][0]["level_dB_SL"][2]
           == computePercentiles ({ tolerance.levels.col (0).begin(), tolerance.levels.col (0).end() })[2]);
    const auto table = toleranceToCsv (tolerance);
    CHECK (table.starts_with ("device,level_dB_SL_1,level_dB_SL_2,suppression_dB_1,suppression_dB_2\n1,"));
    CHECK (std::count (table.begin(), table.end(), '\n') == drawn.draws + 1);
}
