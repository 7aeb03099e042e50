#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/HapticContent.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_tracks/TrackWork.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using Json = nlohmann::json;

namespace
{
WaveformsDescription described (std::string_view text)
{
    return waveformsFromDocument (waveformsDocument (text, "my.file"), "my.file", "my.file");
}

const std::vector<TrackEvent> eventsOf (std::string_view text)
{
    return described (text).tracks.at (0).events;
}

const std::vector<VibrationPoint>& pointsOfEvent (const TrackEvent& event)
{
    return std::get<VibrationSignal> (event.signal).points;
}

std::string ahapEvent (const std::string& more)
{
    return R"({ "Event": { )" + more + " } }";
}

std::string pattern (const std::vector<std::string>& entries)
{
    std::string text = R"({ "Version": 1.0, "Pattern": [ )";

    for (std::size_t i = 0; i < entries.size(); ++i)
        text += (i > 0 ? ", " : "") + entries[i];

    return text + " ] }";
}

/** A motion of so much at intensity 1, m, as its samples at a rate. */
Eigen::VectorXd playedMotion (WaveformsDescription description, double level, double rate)
{
    for (auto& event : description.tracks.at (0).events)
        event.level = { LevelKind::displacement, level };

    return wantedMotion (description, findSkinThreshold ({}), rate).col (0);
}

/** Only what lies in the band of tracks, by a plain sum over frequencies. */
Eigen::VectorXd inUsualBand (const Eigen::VectorXd& samples, double rate)
{
    const auto length = quickLength (4.0 * static_cast<double> (samples.size()));
    auto lines = forwardFourier (samples, length);

    for (Eigen::Index k = 0; k < lines.size(); ++k)
    {
        const auto hertz = static_cast<double> (k) * rate / static_cast<double> (length);
        const auto low = std::clamp ((hertz - 32) / 8, 0.0, 1.0), high = std::clamp ((1150 - hertz) / 150, 0.0, 1.0);
        lines[k] *= std::pow (std::sin (low * std::numbers::pi / 2) * std::sin (high * std::numbers::pi / 2), 2);
    }

    return inverseFourier (lines, length).head (samples.size());
}

double decibels (double ratio)
{
    return 20 * std::log10 (ratio);
}
} // namespace

TEST_CASE ("Sharpness is played as 65 to 300 Hz, along a straight line", "[documents][haptics]")
{
    CHECK (hapticFrequency (0) == 65);
    CHECK (hapticFrequency (0.5) == 182.5);
    CHECK (hapticFrequency (1) == 300);
    CHECK (hapticFrequency (-3) == 65);
    CHECK (hapticFrequency (7) == 300);
}

TEST_CASE ("A transient of a pattern is a burst of 22 ms, with Core Haptics' defaults and clamped values",
           "[documents][haptics]")
{
    const auto events =
        eventsOf (pattern ({ ahapEvent (R"("Time": 0.25, "EventType": "HapticTransient")"),
                             ahapEvent (R"("Time": 0.5, "EventType": "HapticTransient", "Unknown": 7, "EventParameters":
                        [ { "ParameterID": "HapticIntensity", "ParameterValue": 3 },
                          { "ParameterID": "HapticSharpness", "ParameterValue": -1 },
                          { "ParameterID": "AudioPan", "ParameterValue": 0 } ])"),
                             ahapEvent (R"("EventType": "HapticTransient", "EventParameters":
                        [ { "ParameterID": "HapticIntensity", "ParameterValue": 0 } ])") }));
    REQUIRE (events.size() == 2); // What has no intensity is none.
    CHECK (events[0].start == 0.25);
    CHECK (events[0].amplitude == 0.75);
    CHECK (events[1].amplitude == 1);
    const auto& points = pointsOfEvent (events[0]);
    CHECK (points.front().amplitude == 0);
    CHECK (points.back().time == Approx (0.022));
    CHECK (points.back().frequency == 182.5);
    CHECK (pointsOfEvent (events[1]).front().frequency == 65);
}

TEST_CASE ("Audio events of a pattern are left out and counted, what Apple does not define is said",
           "[documents][haptics]")
{
    const auto waveforms =
        described (pattern ({ ahapEvent (R"("EventType": "HapticTransient")"),
                              ahapEvent (R"("EventType": "AudioCustom", "EventWaveformPath": "tap.wav")"),
                              ahapEvent (R"("Time": 1, "EventType": "AudioContinuous", "EventDuration": 1)"),
                              ahapEvent (R"("Time": 1, "EventType": "HapticContinuous")") }));
    CHECK (waveforms.tracks.at (0).events.size() == 1);
    REQUIRE (waveforms.warnings.size() == 3);
    CHECK (waveforms.warnings[0] == "1 continuous event is left out, without EventDuration and so without end.");
    CHECK (waveforms.warnings[1] == "2 audio events are left out.");
    CHECK_THAT (waveforms.warnings[2], Catch::Contains ("65 to 300 Hz") && Catch::Contains ("22 ms"));
    CHECK (waveforms.tracks[0].point.finger.value().name == "medium");
    CHECK (waveforms.tracks[0].events[0].level.kind == LevelKind::sensation);
    CHECK (waveforms.tracks[0].events[0].level.value == 25);

    // It has no place before it is given one.
    Surface surface;
    CHECK_THAT (errorText ([&] { requirePlaces (surface, waveforms); }),
                Catch::Contains ("track 1: has no place; allowed: --at X,Y"));
}

TEST_CASE ("Parameters and curves act on all events from their time on", "[documents][haptics]")
{
    const auto curve = [] (const std::string& id, const std::string& points)
    {
        return R"({ "ParameterCurve": { "ParameterID": ")" + id + R"(", "Time": 0.1, "ParameterCurveControlPoints": [ )"
               + points + " ] } }";
    };
    const auto transient = [] (double time)
    { return ahapEvent (R"("EventType": "HapticTransient", "Time": )" + std::to_string (time)); };
    const auto events = eventsOf (pattern (
        { transient (0), transient (0.1), transient (0.15), transient (0.5), transient (0.7),
          curve ("HapticIntensityControl", R"({ "Time": 0, "ParameterValue": 0.4 },
                                              { "Time": 0.1, "ParameterValue": 0.8 })"),
          curve ("HapticSharpnessControl", R"({ "Time": 0, "ParameterValue": 0.5 })"),
          R"({ "Parameter": { "ParameterID": "HapticIntensityControl", "ParameterValue": 0.2, "Time": 0.6 } })",
          R"({ "Parameter": { "ParameterID": "AudioVolumeControl", "ParameterValue": 0.2, "Time": 0 } })" }));
    REQUIRE (events.size() == 5);
    const std::vector<double> factors { 1, 0.4, 0.6, 0.8, 0.2 };

    for (std::size_t i = 0; i < 5; ++i)
        CHECK (events[i].amplitude == Approx (0.75 * factors[i]));

    CHECK (pointsOfEvent (events[0])[0].frequency == 182.5);
    CHECK (pointsOfEvent (events[1])[0].frequency == 300);
}

// An independent synthesis: what Apple documents, sample by sample, with the phase as a sum over samples at 192 kHz.
TEST_CASE ("A pattern is played as an independent synthesis of it, to 0.1 dB", "[documents][haptics]")
{
    const auto text = pattern (
        { ahapEvent (R"("Time": 0.02, "EventType": "HapticTransient", "EventParameters":
                        [ { "ParameterID": "HapticIntensity", "ParameterValue": 0.8 },
                          { "ParameterID": "HapticSharpness", "ParameterValue": 0.7 } ])"),
          ahapEvent (R"("Time": 0.1, "EventType": "HapticContinuous", "EventDuration": 0.3, "EventParameters":
                        [ { "ParameterID": "HapticIntensity", "ParameterValue": 0.9 },
                          { "ParameterID": "HapticSharpness", "ParameterValue": 0.6 },
                          { "ParameterID": "AttackTime", "ParameterValue": 0.25 },
                          { "ParameterID": "ReleaseTime", "ParameterValue": 0.3 } ])"),
          R"({ "ParameterCurve": { "ParameterID": "HapticIntensityControl", "Time": 0.1, "ParameterCurveControlPoints":
               [ { "Time": 0, "ParameterValue": 0.2 }, { "Time": 0.2, "ParameterValue": 1 },
                 { "Time": 0.4, "ParameterValue": 0.5 } ] } })",
          R"({ "ParameterCurve": { "ParameterID": "HapticSharpnessControl", "Time": 0.1, "ParameterCurveControlPoints":
               [ { "Time": 0, "ParameterValue": 0 }, { "Time": 0.3, "ParameterValue": 1 } ] } })" });
    constexpr double level = 3e-6, rate = 192000;
    const auto wanted = playedMotion (described (text), level, rate);

    const auto count = wanted.size();
    const auto lead = std::lround (0.005 * rate); // A vibration begins 5 ms after its event.
    Eigen::VectorXd tap = Eigen::VectorXd::Zero (count), hum = tap;
    const auto attack = 0.002 + 0.25 * 0.25, release = 0.002 + 0.3 * 0.3;
    double tapPhase = 0, humPhase = 0, humPeak = 0;

    for (Eigen::Index n = lead; n < count; ++n)
    {
        const auto time = static_cast<double> (n - lead) / rate;

        if (const auto since = time - 0.02; since >= 0 && since <= 0.022)
        {
            tap[n] = std::min ({ since / 0.002, (0.022 - since) / 0.002, 1.0 }) * std::sin (tapPhase);
            tapPhase += 2 * std::numbers::pi * (65 + 235 * 0.7) / rate;
        }

        if (const auto since = time - 0.1; since >= 0 && since <= 0.3 + release)
        {
            const auto control = since < 0.2 ? 0.2 + 4 * since : std::max (0.5, 1 - 2.5 * (since - 0.2));
            const auto envelope = std::min ({ since / attack, 1.0, 1 - (since - 0.3) / release });
            hum[n] = 0.9 * control * envelope * std::sin (humPhase);
            humPeak = std::max (humPeak, 0.9 * control * envelope);
            humPhase += 2 * std::numbers::pi * (65 + 235 * std::min (1.0, 0.6 + std::min (1.0, since / 0.3))) / rate;
        }
    }

    tap = inUsualBand (tap, rate);
    hum = inUsualBand (hum, rate);
    const Eigen::VectorXd expected =
        level * (0.8 / tap.cwiseAbs().maxCoeff() * tap + humPeak / hum.cwiseAbs().maxCoeff() * hum);
    CHECK (std::abs (decibels (wanted.norm() / expected.norm())) < 0.1);
    CHECK (std::abs (decibels (wanted.cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff())) < 0.1);
    CHECK ((wanted - expected).norm() < 0.0115 * expected.norm()); // 0.1 dB sample by sample.
}

TEST_CASE ("An event of intensity 1 has the sensation level of its track, one of 0.5 is 6 dB less",
           "[documents][haptics]")
{
    constexpr double rate = 12000;
    const auto threshold = findSkinThreshold ({});
    const auto amountOf = [&] (const char* intensity, double level)
    {
        auto waveforms = described (pattern ({ ahapEvent (
            R"("EventType": "HapticTransient", "EventParameters": [ { "ParameterID": "HapticIntensity", "ParameterValue": )"
            + std::string (intensity) + " } ]") }));
        waveforms.tracks[0].events[0].level.value = level;
        return wantedMotion (waveforms, threshold, rate).cwiseAbs().maxCoeff();
    };
    CHECK (decibels (amountOf ("1", 25) / amountOf ("0.5", 25)) == Approx (6.02).margin (0.01));
    CHECK (decibels (amountOf ("1", 31) / amountOf ("1", 25)) == Approx (6).margin (0.01));
}

TEST_CASE ("HJIF is the sum of its bands as the reference software synthesises them", "[documents][haptics]")
{
    const std::string text = R"({ "version": "2023", "timescale": 1000, "perceptions": [
        { "id": 0, "perception_modality": "Temperature", "channels": [] },
        { "id": 1, "perception_modality": "Vibrotactile",
          "effect_library": [ { "id": 3, "effect_type": "Basis", "position": 0, "keyframes":
              [ { "relative_position": 0, "amplitude_modulation": 0.3, "frequency_modulation": 150 } ] } ],
          "channels": [ { "id": 0, "gain": 0.5, "bands": [
            { "band_type": "VectorialWave", "lower_frequency_limit": 0, "upper_frequency_limit": 1000, "effects": [
              { "effect_type": "Basis", "position": 100, "phase": 0, "base_signal": "Sine", "keyframes": [
                { "relative_position": 0, "amplitude_modulation": 0, "frequency_modulation": 100 },
                { "relative_position": 50, "amplitude_modulation": 0.8 },
                { "relative_position": 100, "amplitude_modulation": 0, "frequency_modulation": 200 } ] } ] },
            { "band_type": "Transient", "effects": [ { "effect_type": "Reference", "id": 3, "position": 20 } ] },
            { "band_type": "Curve", "curve_type": "Linear", "effects": [ { "position": 250, "keyframes": [
                { "relative_position": 0, "amplitude_modulation": 0 },
                { "relative_position": 5, "amplitude_modulation": 0.5 },
                { "relative_position": 10, "amplitude_modulation": 0 } ] } ] } ] } ] } ] })";
    const auto waveforms = described (text);
    REQUIRE (waveforms.warnings.size() == 1);
    CHECK (waveforms.warnings[0] == "1 perception that is not vibrotactile: left out.");
    const auto& event = waveforms.tracks.at (0).events.at (0);
    const auto& sampled = std::get<SampledSignal> (event.signal);
    const auto at = [&] (double time) { return sampled.samples[std::lround ((0.005 + time) * sampled.sampleRate)]; };
    const auto turn = 2 * std::numbers::pi;

    // A chirp from 100 to 200 Hz within 0.1 s: turns of 100 t + 500 t^2.
    for (const double t : { 0.02, 0.033, 0.07, 0.085 })
        CHECK (at (0.1 + t)
               == Approx (0.5 * 0.8 * std::min (t, 0.1 - t) / 0.05 * std::sin (turn * (100 * t + 500 * t * t)))
                      .margin (2e-4));

    CHECK (at (0.03) == Approx (0.5 * 0.3 * std::sin (turn * 150 * 0.01)).margin (1e-9));
    CHECK (at (0.253) == Approx (0.5 * 0.5 * 0.6));
    CHECK (at (0.05) == 0);
    CHECK (event.amplitude == Approx (sampled.samples.cwiseAbs().maxCoeff()));
}

TEST_CASE ("Of HJIF, coded recordings and composite effects are refused by name", "[documents][haptics]")
{
    const auto refusal = [] (const std::string& band)
    {
        return errorText (
            [&]
            {
                described (R"({ "perceptions": [ { "perception_modality": "Vibrotactile", "channels": [ { "bands": [ )"
                           + band + " ] } ] } ] }");
            });
    };
    CHECK_THAT (
        refusal (R"({ "band_type": "WaveletWave", "effects": [] })"),
        Catch::StartsWith ("my.file: /perceptions/0/channels/0/bands/0/band_type: is a coded recording; allowed"));
    CHECK_THAT (refusal (R"({ "band_type": "Wave", "effects": [] })"), Catch::Contains ("one of 'VectorialWave'"));
    CHECK_THAT (refusal (R"({ "band_type": "Curve", "effects": [ { "position": 0, "effect_type": "Composite" } ] })"),
                Catch::Contains ("allowed: Basis, Reference"));
    CHECK_THAT (
        refusal (R"({ "band_type": "Curve", "effects": [ { "position": 0, "effect_type": "Reference", "id": 4 } ] })"),
        Catch::Contains ("which the effect_library does not have"));
    CHECK (refusal ("") == "my.file: has no vibration; allowed: at least one with an intensity above 0");
}

TEST_CASE ("Android's waveforms, envelopes, primitives and predefined effects are read in their order",
           "[documents][haptics]")
{
    const auto waveforms = described (R"(<vibration-effect>
        <waveform-effect>
          <waveform-entry durationMs="20" amplitude="255"/>
          <waveform-entry durationMs="30" amplitude="0"/>
          <repeating><waveform-entry durationMs="50" amplitude="default"/></repeating>
        </waveform-effect>
        <primitive-effect name="click" scale="0.5" delayMs="100"/>
        <predefined-effect name="double_click"/>
        <basic-envelope-effect initialSharpness="0">
          <control-point intensity="0.6" sharpness="1" durationMs="40"/>
          <control-point intensity="0" sharpness="1" durationMs="40"/>
        </basic-envelope-effect>
      </vibration-effect>)");
    const auto& events = waveforms.tracks.at (0).events;
    REQUIRE (events.size() == 5);
    const auto& steps = pointsOfEvent (events[0]);
    CHECK (steps[1].amplitude == 1);
    CHECK (steps[3].amplitude == 0);
    CHECK (steps.back().time == Approx (0.102));
    CHECK (events[1].start == Approx (0.2));
    CHECK (events[1].amplitude == 0.5);
    CHECK (events[2].start == Approx (0.222));
    CHECK (events[3].start == Approx (0.322));
    CHECK (events[4].start == Approx (0.344));
    CHECK (events[4].amplitude == 0.6);
    CHECK (pointsOfEvent (events[4])[0].frequency == 65);
    CHECK (pointsOfEvent (events[4])[1].frequency == 300);
    REQUIRE (waveforms.warnings.size() == 3);
    CHECK (waveforms.warnings[0] == "What repeats is played once.");

    const auto timings = eventsOf (R"({ "timings": [10, 20], "amplitudes": [51, 0] })").at (0);
    CHECK (timings.amplitude == 0.2);
    CHECK (pointsOfEvent (eventsOf (R"({ "timings": [10, 20] })").at (0))[2].amplitude == 0);
}

TEST_CASE ("Android's effects that make no sense are refused with their line", "[documents][haptics]")
{
    const auto refusal = [] (const std::string& inside)
    { return errorText ([&] { described ("<vibration-effect>\n" + inside + "</vibration-effect>"); }); };
    CHECK (
        refusal (R"(<primitive-effect name="clik"/>)")
        == "my.file: line 2: primitive-effect: is 'clik'; allowed: double_click, 'click', 'tick', 'low_tick', 'thud', "
           "'spin', 'quick_rise', 'slow_rise', 'quick_fall', 'heavy_click'");
    CHECK (refusal (R"(<primitive-effect name="click" scale="2"/>)")
           == "my.file: line 2: primitive-effect: scale is '2'; allowed: 0 to 1");
    CHECK (refusal (R"(<waveform-effect><waveform-entry amplitude="1"/></waveform-effect>)")
           == "my.file: line 2: waveform-entry: durationMs is missing; allowed: 0 to 600000");
    CHECK_THAT (refusal ("<vendor-effect/>"), Catch::Contains ("vendor-effect: is not known; allowed: "));
    CHECK_THAT (refusal ("<waveform-effect>"), Catch::Contains ("is not XML"));
    CHECK_THAT (errorText ([] { described ("<svg/>"); }), Catch::Contains ("svg: is no effect; allowed: "));
}

TEST_CASE ("A file of haptic content is waveforms, and events of a track in waveforms", "[documents][haptics]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "tap.ahap";
    writeWholeFile (file, pattern ({ ahapEvent (R"("EventType": "HapticTransient")") }));
    const auto alone = loadWaveforms (file.string(), { "waveforms.tracks.0.x_mm=20", "waveforms.tracks.0.level_um=4" });
    CHECK (alone.name == "tap");
    CHECK (alone.tracks.at (0).point.x == 0.02);
    CHECK (alone.tracks[0].events.at (0).level.value == Approx (4e-6));

    writeWholeFile (folder.path() / "two.json", R"({ "schema": "antinode.waveforms/1", "tracks": [
        { "x_mm": 20, "events": "tap.ahap" }, { "x_mm": 60, "level_um": 1, "signal": { "kind": "click" } } ] })");
    const auto beside = loadWaveforms ((folder.path() / "two.json").string(), {});
    REQUIRE (beside.tracks.size() == 2);
    CHECK (beside.tracks[0].events.at (0).amplitude == 0.75);
    CHECK_FALSE (beside.tracks[0].point.finger);
    CHECK (beside.warnings == alone.warnings);

    writeWholeFile (folder.path() / "two.json", R"({ "schema": "antinode.waveforms/1", "tracks": [
        { "x_mm": 20, "events": "two.json" } ] })");
    CHECK_THAT (errorText ([&] { loadWaveforms ((folder.path() / "two.json").string(), {}); }),
                Catch::Contains ("two.json: is no haptic content"));
}
