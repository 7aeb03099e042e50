#include "Support/ErrorText.h"
#include "Support/SinePlate.h"

#include <antinode_base/Watch.h>
#include <antinode_render/PlayedTracks.h>
#include <antinode_tracks/LiveTracks.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
TrackSettings liveSettings (double latency)
{
    TrackSettings settings;
    settings.threshold = { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
    settings.latency = latency;
    return settings;
}

WaveformsDescription threePoints()
{
    WaveformsDescription description;
    description.band = { 100, 800 };

    for (const auto& [x, y] : { std::pair { 0.05, 0.06 }, { 0.14, 0.1 } })
    {
        auto& track = description.tracks.emplace_back();
        track.point.x = x;
        track.point.y = y;
        track.events[0].signal = NoiseSignal { 0.2, 0.02, description.tracks.size() };
        track.events[0].level = { LevelKind::displacement, 1e-7 };
    }

    auto& silent = description.silent.emplace_back();
    silent.x = 0.09;
    silent.y = 0.03;
    return description;
}

/** What the surface does, mode by mode from sample to sample: no transform, no filter. A static share, which a sum of
   sines lacks, is left out on both sides; Docs/Results.md has devices that are judged with more modes. */
TrackScores played (const ModalModel& judge, const TrackDesign& design)
{
    const auto motion = playTracks (judge, design.description, design.voltages, 0.3);
    return scoreTracks (motion, design.wanted, design.description.band);
}
} // namespace

TEST_CASE ("Filters give two fingers different noise at once, and a third one silence, within 5 and 20 ms", "[live]")
{
    const test::SinePlate plate;

    for (const auto latency : { 0.005, 0.02 })
    {
        const auto model = plate.model (40);
        const auto design = designLiveTracks (model, threePoints(), liveSettings (latency));
        const auto scores = played (model, design);
        CHECK (design.latency <= latency + 1e-12);
        CHECK (scores.suppression (2) < -45);

        for (const auto finger : { 0u, 1u })
            CHECK (scores.normalisedError (finger) < 1e-4);
    }
}

TEST_CASE ("Levels beyond the limits of a live design are refused with the share that is within", "[live]")
{
    auto model = test::SinePlate().model (20);
    auto description = threePoints();
    const auto free = designLiveTracks (model, description, liveSettings (0.01));

    for (auto& track : description.tracks)
        track.events[0].level.value *= 2 / free.limitUse.unlimitedPeak;

    double share = 0;

    try
    {
        designLiveTracks (model, description, liveSettings (0.01));
    }
    catch (const TrackLimitError& error)
    {
        share = error.share;
    }

    CHECK (share == Approx (0.5));
}

TEST_CASE ("A latency that filters cannot have is refused with what is allowed", "[live]")
{
    const auto model = test::SinePlate().model (6);
    const auto design = [&] (double latency) { designLiveTracks (model, threePoints(), liveSettings (latency)); };
    CHECK (errorText ([&] { design (0.002); }) == "latency: is 2 ms; allowed: 5 to 100 ms");
    CHECK (errorText ([&] { design (0.2); }) == "latency: is 200 ms; allowed: 5 to 100 ms");
}

TEST_CASE ("Live tracks that need too much memory are refused before they are designed", "[live]")
{
    const auto model = test::SinePlate().model (6);
    auto description = threePoints();
    description.tracks[0].events[0].signal = NoiseSignal { 600, 0.02, 1 };
    const auto refusal = errorText ([&] { designLiveTracks (model, description, liveSettings (0.01)); });

    // 12 ceramics and 3 points twice, 8 bytes each.
    CHECK_THAT (refusal, Catch::Contains ("last 600 s") && Catch::Contains ("allowed: 1 GiB, about 93 s"));
}

TEST_CASE ("A watch is asked while live tracks are played through their filters", "[live]")
{
    const auto model = test::SinePlate().model (6);
    auto description = threePoints();
    description.tracks.resize (1);
    description.silent.clear();
    int asked = 0;
    const WatchScope scope ([&] { return ++asked > 0; });
    designFingerFilters (model, description, { 48000, 0.01 });
    const auto byFilters = asked;
    asked = 0;
    designLiveTracks (model, description, liveSettings (0.01));

    // .2 s of 48 kHz, looked at every 10 ms at least.
    CHECK (asked >= byFilters + 20);
}
