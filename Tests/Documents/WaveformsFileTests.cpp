#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/WaveformsFile.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <bit>
#include <cstdint>
#include <limits>

using namespace antinode;
using Json = nlohmann::json;

namespace
{
Json oneTrack()
{
    return Json::parse (R"({ "schema": "antinode.waveforms/1", "tracks": [ { "x_mm": 40, "y_mm": 60, "level_um": 5,
                             "signal": { "kind": "click" } } ] })");
}

std::string refusal (const Json& document, const std::filesystem::path& folder = {})
{
    return errorText ([&] { readWaveforms (document, "my.json", folder); });
}
} // namespace

TEST_CASE ("Waveforms are read with all that they can say", "[documents][tracks]")
{
    auto document = oneTrack();
    document["name"] = "mine";
    document["band_Hz"] = { 50, 800 };
    document["pre_roll_ms"] = 5;
    document["post_roll_ms"] = 15;
    document["tracks"].push_back (Json::parse (R"({ "name": "index", "x_mm": 90, "level_dB_SL": 30, "start_ms": 20,
                          "finger": { "mass_g": 0.1, "damping_N_s_per_m": 1.5, "stiffness_N_per_mm": 0.6 },
                          "signal": { "kind": "tone", "frequency_Hz": 300, "duration_ms": 100, "modulation_Hz": 20 } })"));
    document["tracks"].push_back (Json::parse (
        R"({ "x_mm": 10, "level_mm_s": 2, "signal": { "kind": "noise", "seed": 7, "duration_ms": 80 } })"));
    document["silent"] = Json::parse (R"([ { "x_mm": 70, "y_mm": 30, "finger": "firm" } ])");
    const auto waveforms = readWaveforms (document, "my.json", {});
    CHECK (waveforms.name == "mine");
    CHECK (waveforms.band.lower == 50);
    CHECK (waveforms.band.upper == 800);
    CHECK (waveforms.preRoll == 0.005);
    CHECK (waveforms.postRoll == 0.015);
    REQUIRE (waveforms.tracks.size() == 3);
    CHECK (waveforms.tracks[0].events[0].level.value == Approx (5e-6));
    CHECK (std::holds_alternative<ClickSignal> (waveforms.tracks[0].events[0].signal));
    const auto& index = waveforms.tracks[1];
    CHECK (index.point.name == "index");
    CHECK (index.point.finger.value().mass == Approx (1e-4));
    CHECK (index.point.finger->stiffness == Approx (600));
    CHECK (index.point.finger->x == 0.09);
    CHECK (index.events[0].level.kind == LevelKind::sensation);
    CHECK (index.events[0].start == 0.02);
    CHECK (std::get<ToneSignal> (index.events[0].signal).modulationFrequency == 20);
    CHECK (std::get<NoiseSignal> (waveforms.tracks[2].events[0].signal).seed == 7);
    CHECK (waveforms.tracks[2].events[0].level.kind == LevelKind::velocity);
    REQUIRE (waveforms.silent.size() == 1);
    CHECK (waveforms.silent[0].finger.value().name == "firm");
}

TEST_CASE ("A touched point stays at its place or has a path", "[documents][tracks]")
{
    auto document = oneTrack();
    document["silent"] = Json::parse (R"([ { "path": [ { "time_ms": 0, "x_mm": 70, "y_mm": 30 },
                                                       { "time_ms": 250, "x_mm": 90 } ] } ])");
    const auto point = readWaveforms (document, "my.json", {}).silent.at (0);
    REQUIRE (point.path.size() == 2);
    CHECK (point.x == Approx (0.07));
    CHECK (point.path[1].time == Approx (0.25));
    CHECK (point.path[1].x == Approx (0.09));
    CHECK (point.path[1].y == 0);

    // Half of the way in half of the time; before and behind it stays.
    CHECK (placeAt (point, 0.125).x == Approx (0.08));
    CHECK (placeAt (point, 0.125).y == Approx (0.015));
    CHECK (placeAt (point, -1).y == Approx (0.03));
    CHECK (placeAt (point, 1).x == Approx (0.09));

    document["silent"][0]["x_mm"] = 70;
    CHECK_THAT (refusal (document), Catch::Contains ("/silent/0") && Catch::Contains ("'x_mm' and 'path'"));
    document["silent"][0].erase ("x_mm");
    document["silent"][0]["y_mm"] = 70;
    CHECK_THAT (refusal (document), Catch::Contains ("has both 'y_mm' and 'path'"));
    document["silent"][0].erase ("y_mm");
    document["silent"][0]["path"].erase (1);
    CHECK_THAT (refusal (document), Catch::Contains ("/silent/0/path"));
}

TEST_CASE ("A recording is looked for beside its file, and one channel of it is played", "[documents][tracks]")
{
    const TemporaryFolder folder;
    Eigen::MatrixXd samples (2, 3);
    samples << 0, 0.5, 0, 0, 0, 0.25;
    writeWholeFile (folder.path() / "voice.wav", encodeWave (samples, 1, 8000));
    auto document = oneTrack();
    document["tracks"][0]["signal"] = { { "kind", "wav" }, { "file", "voice.wav" }, { "channel", 2 } };
    const auto waveforms = readWaveforms (document, "my.json", folder.path());
    const auto& recording = std::get<SampledSignal> (waveforms.tracks[0].events[0].signal);
    CHECK (recording.sampleRate == 8000);
    CHECK (recording.samples == Eigen::Vector3d (0, 0, 0.25));

    document["tracks"][0]["signal"]["channel"] = 3;
    CHECK_THAT (refusal (document, folder.path()), Catch::Contains ("/tracks/0/signal/channel"));

    // A value that is no number, in the last sample of the file.
    auto bytes = encodeWave (samples, 1, 8000);
    const auto broken = std::bit_cast<std::uint32_t> (std::numeric_limits<float>::quiet_NaN());

    for (std::size_t i = 0; i < sizeof (broken); ++i)
        bytes[bytes.size() - sizeof (broken) + i] = static_cast<char> (broken >> (8 * i) & 0xff);

    writeWholeFile (folder.path() / "voice.wav", bytes);
    CHECK_THAT (refusal (document, folder.path()),
                Catch::Contains ("voice.wav") && Catch::Contains ("has a sample that is not finite"));
}

TEST_CASE ("A signal may be given as numbers", "[documents][tracks]")
{
    auto document = oneTrack();
    document["tracks"][0]["signal"] = { { "kind", "samples" },
                                        { "sample_rate_Hz", 8000 },
                                        { "values", { 0, 0, 0.25 } } };
    const auto waveforms = readWaveforms (document, "my.json", {});
    const auto& signal = std::get<SampledSignal> (waveforms.tracks[0].events[0].signal);
    CHECK (signal.sampleRate == 8000);
    CHECK (signal.samples == Eigen::Vector3d (0, 0, 0.25));
    document["tracks"][0]["signal"]["values"] = nlohmann::json::array();
    CHECK_THAT (refusal (document), Catch::Contains ("/tracks/0/signal/values"));
    document["tracks"][0]["signal"] = { { "kind", "samples" }, { "values", { 1, 2 } } };
    CHECK_THAT (refusal (document), Catch::Contains ("sample_rate_Hz"));
}

TEST_CASE ("A track takes a list of events, whose level is that of the track unless they have their own",
           "[documents][tracks]")
{
    auto document = oneTrack();
    document["tracks"][0].erase ("signal");
    document["tracks"][0]["events"] = Json::parse (
        R"([ { "signal": { "kind": "click" } },
             { "start_ms": 80, "amplitude": 0.5, "signal": { "kind": "tone", "frequency_Hz": 200 } },
             { "start_ms": 400, "level_dB_SL": 20, "signal": { "kind": "gabor" } } ])");
    const auto events = readWaveforms (document, "my.json", {}).tracks.at (0).events;
    REQUIRE (events.size() == 3);
    CHECK (events[0].level.value == Approx (5e-6));
    CHECK (events[1].level.value == Approx (5e-6));
    CHECK (events[1].amplitude == 0.5);
    CHECK (events[1].start == 0.08);
    CHECK (events[2].level.kind == LevelKind::sensation);
    CHECK (std::holds_alternative<GaborSignal> (events[2].signal));

    // Where nothing gives a level.
    document["tracks"][0].erase ("level_um");
    const auto usual = readWaveforms (document, "my.json", {}).tracks.at (0).events[0].level;
    CHECK (usual.kind == LevelKind::sensation);
    CHECK (usual.value == 25);
}

TEST_CASE ("Tracks at one place are summed, with a sentence", "[documents][tracks]")
{
    auto document = oneTrack();
    document["tracks"].push_back (Json::parse (R"({ "x_mm": 90, "level_um": 2, "signal": { "kind": "click" } })"));
    document["tracks"].push_back (Json::parse (
        R"({ "x_mm": 40, "y_mm": 60, "finger": "medium", "level_um": 1, "start_ms": 9, "signal": { "kind": "gabor" } })"));
    const auto waveforms = readWaveforms (document, "my.json", {});
    REQUIRE (waveforms.tracks.size() == 2);
    REQUIRE (waveforms.tracks[0].events.size() == 2);
    CHECK (waveforms.tracks[0].events[1].start == 0.009);
    CHECK (waveforms.tracks[0].point.finger.has_value());
    REQUIRE (waveforms.warnings.size() == 1);
    CHECK (waveforms.warnings[0] == "Track 3 is at the place of another track: the waveform there is their sum.");
}

TEST_CASE ("Waveforms that make no sense are refused with their place", "[documents][tracks]")
{
    auto document = oneTrack();
    document["tracks"][0]["level_mm_s"] = 1;
    CHECK_THAT (refusal (document), Catch::Contains ("/tracks/0") && Catch::Contains ("has several levels"));
    document = oneTrack();
    document["tracks"][0]["events"] = Json::array ({ { { "signal", { { "kind", "click" } } } } });
    CHECK_THAT (refusal (document), Catch::Contains ("'signal' and 'events'"));
    document["tracks"][0].erase ("signal");
    document["tracks"][0]["start_ms"] = 5;
    CHECK_THAT (refusal (document), Catch::Contains ("/tracks/0") && Catch::Contains ("allowed: in each event"));
    document = oneTrack();
    document["band_Hz"] = { 500, 100 };
    CHECK (refusal (document) == "my.json: /band_Hz: does not ascend; allowed: a lower and a higher frequency, Hz");
    document = oneTrack();
    document["tracks"][0]["signal"]["kind"] = "clik";
    CHECK_THAT (refusal (document), Catch::Contains ("did you mean 'click'"));
    document = oneTrack();
    document["tracks"][0]["finger"] = "hand";
    CHECK_THAT (refusal (document), Catch::Contains ("/tracks/0/finger") && Catch::Contains ("'medium'"));
    document = oneTrack();
    document["tracks"] = Json::array();
    CHECK_THAT (refusal (document), Catch::Contains ("/tracks"));
    document = oneTrack();
    document["schema"] = "antinode.focus/1";
    CHECK_THAT (refusal (document), Catch::Contains ("antinode.waveforms/1"));
}
