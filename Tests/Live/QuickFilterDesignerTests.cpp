#include "Support/ErrorText.h"
#include "Support/SinePlate.h"

#include <antinode_base/Watch.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_render/PlayedTracks.h>
#include <antinode_tracks/FilterDesign.h>
#include <antinode_tracks/LiveTracks.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr TrackBand band { 100, 800 };

WaveformsDescription fingersAt (const std::vector<std::pair<double, double>>& places)
{
    WaveformsDescription description;
    description.band = band;

    for (const auto& [x, y] : places)
    {
        auto& track = description.tracks.emplace_back();
        track.point.x = x;
        track.point.y = y;
        track.events[0].signal = NoiseSignal { 0.2, 0.02, description.tracks.size() };
        track.events[0].level = { LevelKind::displacement, 1e-7 };
    }

    return description;
}

TrackSettings liveSettings()
{
    TrackSettings settings;
    settings.threshold = { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
    settings.latency = FilterSettings().latency;
    return settings;
}

/** Mode by mode from sample to sample: no transform, no filter, no mix of ceramics. */
TrackScores played (const ModalModel& model, const WaveformsDescription& description, const FingerFilters& filters)
{
    const auto design = liveTracks (model, description, liveSettings(), filters);
    return scoreTracks (playTracks (model, description, design.voltages, 0.3), design.wanted, description.band);
}
} // namespace

TEST_CASE ("Quick filters give each of 2 to 5 fingers its own noise", "[live]")
{
    const auto model = test::SinePlate().model (40);
    const QuickFilterDesigner designer (std::make_shared<const ModalModel> (model), band, {});
    const std::vector<std::pair<double, double>> places {
        { 0.05, 0.06 }, { 0.14, 0.1 }, { 0.09, 0.03 }, { 0.03, 0.12 }, { 0.17, 0.04 }
    };

    for (const std::size_t count : { 2, 3, 5 })
    {
        auto description = fingersAt (places);
        description.tracks.resize (count);
        const auto filters = designer.design (description);
        const auto scores = played (model, description, filters);
        CHECK (filters.error < 0.01);

        for (std::size_t finger = 0; finger < count; ++finger)
            CHECK (scores.suppression (finger) < -40);
    }
}

TEST_CASE ("Quick filters know the fingers that rest on the surface", "[live]")
{
    const auto model = test::SinePlate().model (40);
    const QuickFilterDesigner designer (std::make_shared<const ModalModel> (model), band, {});
    const auto bare = fingersAt ({ { 0.05, 0.06 }, { 0.14, 0.1 } });
    auto known = bare;
    std::vector<Finger> fingers;

    for (auto& track : known.tracks)
    {
        fingers.push_back ({ "heavy", track.point.x, track.point.y, 0.005, 2e-3, 20, 5000 });
        track.point.finger = fingers.back();
    }

    // Fingers as complex modes, not as terms of rank one.
    const auto loaded = loadedModel (model, fingers);
    const auto error = [&] (const WaveformsDescription& designed)
    { return played (loaded, bare, designer.design (designed)).suppression (0); };
    CHECK (error (known) < -40);
    CHECK (error (bare) > -25);
}

TEST_CASE ("Quick filters can take the place of full ones in a player", "[live]")
{
    const auto model = test::SinePlate().model (20);
    const auto description = fingersAt ({ { 0.05, 0.06 }, { 0.14, 0.1 } });
    const QuickFilterDesigner designer (std::make_shared<const ModalModel> (model), band, {});
    const auto quick = designer.design (description), full = designFingerFilters (model, description, {});
    REQUIRE (quick.taps.size() == full.taps.size());
    CHECK (quick.taps[1].rows() == full.taps[1].rows());
    CHECK (quick.taps[1].cols() == full.taps[1].cols());
    CHECK (quick.factor == full.factor);
    CHECK (quick.latency() == full.latency());
}

TEST_CASE ("Fingers at one place get quick filters that are finite, and say how wrong they are", "[live]")
{
    const auto model = test::SinePlate().model (20);
    const QuickFilterDesigner designer (std::make_shared<const ModalModel> (model), band, {});
    const auto filters = designer.design (fingersAt ({ { 0.05, 0.06 }, { 0.05, 0.06 } }));
    CHECK (filters.taps[0].allFinite());
    CHECK (filters.error > 0.5); // Two different motions of one place: half of each is missing.
    CHECK (filters.error < 1);
}

TEST_CASE ("Quick filters refuse places outside the surface and points that move", "[live]")
{
    const QuickFilterDesigner designer (std::make_shared<const ModalModel> (test::SinePlate().model (6)), band, {});
    auto description = fingersAt ({ { 0.3, 0.06 } });
    CHECK_THAT (errorText ([&] { designer.design (description); }), Catch::Contains ("allowed: 0 to 200 mm"));
    description.tracks[0].point.x = 0.1;
    description.tracks[0].point.path = { { 0, 0.1, 0.06 }, { 1, 0.12, 0.06 } };
    CHECK_THAT (errorText ([&] { designer.design (description); }),
                Catch::Contains ("takes places") || Catch::Contains ("take places"));
}

TEST_CASE ("A watch ends a quick design", "[live]")
{
    const QuickFilterDesigner designer (std::make_shared<const ModalModel> (test::SinePlate().model (20)), band, {});
    const auto description = fingersAt ({ { 0.05, 0.06 }, { 0.14, 0.1 } });
    const WatchScope scope ([] { return false; });
    CHECK_THROWS_AS (designer.design (description), Cancelled);
}
