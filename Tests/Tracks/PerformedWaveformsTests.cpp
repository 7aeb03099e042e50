#include "Support/SinePlate.h"

#include <antinode_documents/DesignFile.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_render/PerformedWaveforms.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace antinode;

namespace
{
/** A burst at one finger and a tone at another; a third feels nothing. */
WaveformsDescription threeFingers()
{
    WaveformsDescription description;
    description.band = { 100, 800 };
    const auto touch = [] (TouchedPoint& point, double x, double y)
    {
        point.x = x;
        point.y = y;
        point.finger = builtInFinger ("medium", x, y);
    };
    description.tracks.resize (2);
    touch (description.tracks[0].point, 0.05, 0.06);
    description.tracks[0].events[0].signal = GaborSignal { 350, 0.01 };
    description.tracks[0].events[0].level.value = 1e-6;
    touch (description.tracks[1].point, 0.14, 0.1);
    description.tracks[1].events[0].signal = ToneSignal { 300, 0.06, 0.02, 0, 1 };
    description.tracks[1].events[0].level.value = 0.5e-6;
    description.silent.resize (1);
    touch (description.silent[0], 0.15, 0.04);
    return description;
}

PerformedWaveforms performed (const WaveformsDescription& description)
{
    const auto model = test::SinePlate().model (20);
    TrackSettings settings;
    settings.threshold = { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
    return performWaveforms (model, model, description, settings);
}
} // namespace

// Design: real modes, fingers line by line as terms of rank one. Judge: the complex modes of the loaded surface, sample
// by sample.
TEST_CASE ("Every finger gets its track, played on the modes of the surface with the fingers on it", "[tracks][render]")
{
    const auto result = performed (threeFingers());
    REQUIRE (result.scores.fingers.size() == 3);

    for (std::size_t p = 0; p < 3; ++p)
        CHECK (result.scores.suppression (p) < -55);

    CHECK (result.scores.normalisedError (0) < 1e-5);
    CHECK (result.scores.normalisedError (1) < 1e-4);
    CHECK (result.scores.fingers[0].reachedPeak == Approx (1e-6).epsilon (0.02));
    CHECK (result.felt.targets[0].level > 15);
    CHECK (result.felt.targets[2].level < -20);

    const auto json = performedToJson (result);
    CHECK (json["schema"] == "antinode.performance/1");
    CHECK (json["fingers"].size() == 3);
    CHECK (json["fingers"][2]["name"] == "silent finger 1");
    CHECK_FALSE (json["fingers"][2].contains ("normalised_error"));
    CHECK (json["peak_voltage_V"].get<double>() > 0);
    CHECK (json.contains ("power"));

    // A device is some per cent beside its model: far from what the model promises, and still of use.
    for (std::size_t p = 0; p < 3; ++p)
    {
        CHECK (result.expected.at (p) > -50);
        CHECK (result.expected[p] < -10);
        CHECK (json["fingers"][p]["expected_suppression_dB"] == result.expected[p]);
    }
}

TEST_CASE ("Devices that measured modes may stand for differ by 4 % a mode, the same ones each time", "[tracks]")
{
    auto model = test::SinePlate().model (20);
    model.origin = { ModeSource::measured, 96, 0.002, true };
    double squares = 0;
    constexpr int draws = 100;

    for (std::uint64_t number = 0; number < draws; ++number)
    {
        const auto device = likelyDevice (model, number);
        CHECK (device.participation == likelyDevice (model, number).participation);
        CHECK (device.shapes == model.shapes);
        CHECK ((device.angularFrequencies.cwiseQuotient (model.angularFrequencies).array() - 1).abs().maxCoeff()
               < 1e-4);
        const Eigen::VectorXd factors =
            device.participation.rowwise().norm().cwiseQuotient (model.participation.rowwise().norm());
        squares += (factors.array() - 1).square().mean() / draws;
    }

    CHECK (std::sqrt (squares) == Approx (0.04).epsilon (0.1));
}

TEST_CASE ("A point that moves is played, felt and told about on its way", "[tracks][render]")
{
    auto description = threeFingers();
    auto& sliding = description.tracks[1].point;
    sliding.finger.reset();
    sliding.path = { { 0, 0.14, 0.1 }, { 0.06, 0.11, 0.11 } };
    const auto result = performed (description);

    for (std::size_t p = 0; p < 3; ++p)
        CHECK (result.scores.suppression (p) < -55);

    // A tone of .5 um over a threshold of .1 um: 14 dB, as where it stays.
    CHECK (result.felt.targets[1].level == Approx (20 * std::log10 (5)).margin (0.5));
    const auto json = performedToJson (result);
    CHECK (json["fingers"][1]["path"][1]["x_mm"].get<double>() == Approx (110));
    CHECK_FALSE (json["fingers"][0].contains ("path"));

    // Who stays where the path begins feels something else.
    sliding.path.clear();
    const auto played = playTracks (result.judge, description, result.design.voltages, 0.3);
    const auto scores = scoreTracks (played, result.design.wanted, description.band);
    CHECK (scores.suppression (1) > -30);
}

TEST_CASE ("Fingers that no design knows of spoil the silence", "[tracks][render]")
{
    auto description = threeFingers();
    description.tracks[0].point.finger->isKnown = false;
    description.tracks[1].point.finger->isKnown = false;
    description.silent[0].finger->isKnown = false;
    CHECK (performed (description).scores.suppression (2) > -40);
}

// Read back and played as any design: the voltages come from the limiter of a render, at their own rate.
TEST_CASE ("Waveforms at fingers written as a design are played as they were designed", "[tracks][render]")
{
    auto own = test::SinePlate().model (20);
    own.name = "sine";
    const auto result = performed (threeFingers());
    const auto json = nlohmann::json::parse (designToJson (performedDesign (result, own), own).dump());
    const auto read = readDesign (json, "design.json", own);
    const auto& voltages = result.design.voltages;
    RenderSettings settings;
    settings.playback = voltages.playback;
    settings.duration = static_cast<double> (voltages.values.cols()) / voltages.playback.sampleRate;
    settings.probeShapes.resize (0, own.modes());
    const auto rendered = renderOffline (own, read.program, settings).voltages;
    CHECK ((rendered.leftCols (voltages.values.cols()) - voltages.values).cwiseAbs().maxCoeff()
           < 1e-9 * voltages.values.cwiseAbs().maxCoeff());
    CHECK (read.description.fingers.size() == 3);
    CHECK_FALSE (read.description.fingers[0].isKnown);
    CHECK (peakVoltage (read) == Approx (result.design.peaks.maxCoeff()));

    // The burst of 350 Hz is faster than the tone: 2 pi f times its displacement, at the first finger.
    const auto& target = read.description.targets.front();
    CHECK (target.x == 0.05);
    CHECK (target.peakVelocity == Approx (2 * 3.14159 * 350 * 1e-6).epsilon (0.05));
}
