#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_base/Prefixes.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_sweep/CaseEvaluator.h>
#include <antinode_sweep/PartFolder.h>
#include <antinode_sweep/SweepInputs.h>
#include <antinode_sweep/SweepTable.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
/** A burst at one finger of a beam, nothing at another. */
const std::string twoFingers = R"({"schema": "antinode.waveforms/1", "name": "two", "device": "beam",
    "band_Hz": [40, 1000], "tracks": [{"x_mm": 30, "level_um": 0.1,
    "signal": {"kind": "gabor", "frequency_Hz": 500, "width_ms": 6}}], "silent": [{"x_mm": 60}]})";

SweepInputs inputsOfWaveforms (const TemporaryFolder& folder, const std::string& more)
{
    writeWholeFile (folder.path() / "two.json", twoFingers);
    writeWholeFile (folder.path() / "plan.json",
                    R"({"schema": "antinode.sweep/1", "waveforms": "./two.json", )" + more + "}");
    return loadSweep (folder.path() / "plan.json");
}

const std::string recorded =
    R"("record": ["peak_voltage_V", "fingers.0.reached_peak_um", "fingers.1.suppression_dB", "fingers.0.level_dB_SL"])";
} // namespace

TEST_CASE ("A case of waveforms is what perform says of them", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOfWaveforms (
        folder, recorded + R"(, "vary": [{"key": "waveforms.tracks.0.level_um", "values": [0.1, 0.2]}])");
    const CaseEvaluator evaluator (inputs, false);
    evaluator.check();
    const auto first = evaluator.evaluate (0), second = evaluator.evaluate (1);
    REQUIRE (first.error.empty());
    REQUIRE (second.error.empty());

    const auto [known, judge] = trackModels (loadDevice ("beam", {}), false);
    TrackSettings settings;
    settings.threshold = findSkinThreshold ({});
    const auto performed =
        performWaveforms (known, judge, loadWaveforms ((folder.path() / "two.json").string(), {}), settings);
    CHECK (first.values[0] == performed.design.peaks.maxCoeff());
    CHECK (first.values[1] == performed.scores.fingers[0].reachedPeak * micro);
    CHECK (first.values[2] == performed.scores.suppression (1));

    // Volts follow the level; what is left at the other finger, relative to the track, does not.
    CHECK (second.values[0] == Approx (2 * first.values[0]).epsilon (1e-6));
    CHECK (second.values[1] == Approx (2 * first.values[1]).epsilon (1e-6));
}

TEST_CASE ("Waveforms are designed for the known device and played on one that deviates", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    const auto inputs =
        inputsOfWaveforms (folder, recorded + R"(, "vary": [{"key": "deviation.voltage_percent", "values": [0, 10]}])");
    const CaseEvaluator evaluator (inputs, false);
    const auto nominal = evaluator.evaluate (0), louder = evaluator.evaluate (1);
    REQUIRE (louder.error.empty());
    CHECK (louder.values[0] == nominal.values[0]);
    CHECK (louder.values[1] == Approx (1.1 * nominal.values[1]).epsilon (1e-9));

    const auto spread = inputsOfWaveforms (folder, recorded + R"(, "scheme": "random", "cases": 2,
        "set": {"deviation.frequency_spread_percent": 0.5, "deviation.damping_spread_percent": 10})");
    const CaseEvaluator drawn (spread, false);
    const auto one = drawn.evaluate (0), other = drawn.evaluate (1);
    REQUIRE (one.error.empty());
    CHECK (one.values[0] == nominal.values[0]);
    // What modes beyond the design's leave is -45 dB (-50 of a thin beam: with shear the sum over modes converges more
    // slowly); what deviates adds to it.
    CHECK (nominal.values[2] < -45);
    CHECK (one.values[2] > nominal.values[2]);
    CHECK (one.values[2] != other.values[2]);
}

TEST_CASE ("Cases of waveforms have the same bits in any order, on any number of threads", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOfWaveforms (folder, recorded + R"(, "scheme": "random", "cases": 6, "vary": [
        {"key": "waveforms.silent.0.x_mm", "uniform": {"minimum": 50, "maximum": 70}},
        {"key": "deviation.damping_percent", "normal": {"mean": 0, "standard_deviation": 10}}])");
    const CaseEvaluator evaluator (inputs, false);
    const auto evaluate = [&] (std::uint64_t number) { return evaluator.evaluate (number); };
    const auto single = sweepFolder (folder.path() / "single", inputs),
               shards = sweepFolder (folder.path() / "s", inputs);
    computeParts (evaluate, single, single.missing ({}), 1, {});
    computeParts (evaluate, shards, shards.missing ({ 2, 2 }), 2, {});
    computeParts (evaluate, shards, shards.missing ({ 1, 2 }), 3, {});
    CHECK (sweepToMatlab (mergeParts (single, inputs)) == sweepToMatlab (mergeParts (shards, inputs)));
    CHECK (mergeParts (single, inputs).failed() == 0);
}

TEST_CASE ("A plan keeps the recordings that its waveforms name, and is another plan when one changes",
           "[sweep][tracks]")
{
    const TemporaryFolder folder;
    Eigen::RowVectorXd samples (800);

    for (Eigen::Index n = 0; n < samples.size(); ++n)
        samples[n] = std::sin (0.3 * static_cast<double> (n));

    writeWholeFile (folder.path() / "voice.wav", encodeWave (samples, 1, 8000));
    const auto keys =
        recorded + R"(, "device": "beam", "waveforms": {"schema": "antinode.waveforms/1", "tracks": [{"x_mm": 30,
        "level_um": 0.1, "signal": {"kind": "wav", "file": "voice.wav"}}], "silent": [{"x_mm": 60}]}})";
    const auto load = [&]
    {
        writeWholeFile (folder.path() / "plan.json", R"({"schema": "antinode.sweep/1", )" + keys);
        return loadSweep (folder.path() / "plan.json");
    };
    const auto inputs = load();
    const auto direct = CaseEvaluator (inputs, false).evaluate (0);
    REQUIRE (direct.error.empty());

    // Elsewhere, without the file.
    const auto received = sweepInputs (nlohmann::json::parse (inputs.document.dump()), "plan");
    CHECK (received.hash == inputs.hash);
    CHECK (CaseEvaluator (received, false).evaluate (0).values == direct.values);

    writeWholeFile (folder.path() / "voice.wav", encodeWave (0.5 * samples, 1, 8000));
    CHECK (load().hash != inputs.hash);
}

TEST_CASE ("Waveforms get their recordings, and what is no waveforms stays", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    Eigen::MatrixXd samples (2, 3);
    samples << 0, 0.5, 0, 0, 0, 0.25;
    writeWholeFile (folder.path() / "voice.wav", encodeWave (samples, 1, 8000));
    auto document = nlohmann::json::parse (twoFingers);
    CHECK (withRecordings (document, "my.json", folder.path()) == document);
    document["tracks"][0]["signal"] = { { "kind", "wav" }, { "file", "voice.wav" }, { "channel", 2 } };
    const auto whole = withRecordings (document, "my.json", folder.path());
    CHECK (whole["tracks"][0]["signal"]["values"] == nlohmann::json ({ 0.0, 0.0, 0.25 }));
    CHECK (whole["tracks"][0]["signal"]["sample_rate_Hz"] == 8000);
    document["tracks"][0]["signal"]["file"] = "absent.wav";
    CHECK_THAT (errorText ([&] { withRecordings (document, "my.json", folder.path()); }),
                Catch::Contains ("absent.wav"));

    for (const auto* const text :
         { "[]", "3", R"({"tracks": 1})", R"({"tracks": [1, {"signal": 2}, {"signal": {"kind": 3}}]})" })
        CHECK (withRecordings (nlohmann::json::parse (text), "my.json", {}).dump()
               == nlohmann::json::parse (text).dump());
}

TEST_CASE ("A plan over haptic content has it as events, and its recordings within events", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    writeWholeFile (folder.path() / "tap.ahap", R"({"Pattern": [{"Event": {"EventType": "HapticTransient"}}]})");
    writeWholeFile (folder.path() / "voice.wav", encodeWave (Eigen::MatrixXd::Constant (1, 3, 0.25), 1, 8000));
    const auto planned = [&] (const std::string& waveforms)
    {
        writeWholeFile (folder.path() / "plan.json", R"({"schema": "antinode.sweep/1", "device": "beam", "waveforms": )"
                                                         + waveforms + R"(, "record": ["peak_voltage_V"],
                                                         "set": {"waveforms.tracks.0.x_mm": 30, "waveforms.tracks.0.level_um": 0.01}})");
        return loadSweep (folder.path() / "plan.json");
    };
    const auto tap = planned ("\"./tap.ahap\"");
    CHECK (tap.document["waveforms"]["tracks"][0]["events"][0]["signal"]["kind"] == "vibration");
    CaseEvaluator (tap, false).check();

    const auto both = planned (R"({"schema": "antinode.waveforms/1", "tracks": [{"events": "tap.ahap"}, {"x_mm": 60,
        "events": [{"signal": {"kind": "wav", "file": "voice.wav"}}]}]})");
    CHECK (both.document["waveforms"]["tracks"][0]["events"].size() == 1);
    CHECK (both.document["waveforms"]["tracks"][1]["events"][0]["signal"]["kind"] == "samples");
    CHECK (both.document["waveforms"]["warnings"].size() == 1);
}

TEST_CASE ("Plans over waveforms that make no sense are refused with one sentence", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    const auto refusal = [&] (const std::string& more)
    { return errorText ([&] { CaseEvaluator (inputsOfWaveforms (folder, more), false).check(); }); };
    CHECK_THAT (refusal (R"("focus": "demonstrator", "record": ["peak_voltage_V"])"),
                Catch::Contains ("both 'focus' and 'waveforms'"));
    CHECK_THAT (refusal (recorded + R"(, "evaluate": "closed_form")"), Catch::Contains ("'closed_form'"));
    CHECK_THAT (refusal (recorded + R"(, "points_mm": [[24, 0]])"), Catch::Contains ("'points_mm'"));
    CHECK_THAT (refusal (recorded + R"(, "set": {"focus.targets.0.x_mm": 3})"), Catch::Contains ("has no focus"));
    CHECK_THAT (refusal (recorded + R"(, "set": {"waveforms.device": "beam"})"), Catch::Contains ("own key 'device'"));
    CHECK_THAT (refusal (recorded + R"(, "set": {"waveforms.colour": 3})"), Catch::Contains ("colour"));
    CHECK_THAT (refusal (recorded + R"(, "latency_ms": 0)"), Catch::Contains ("/latency_ms"));
    CHECK_THAT (refusal (R"("record": ["fingers.7.level_dB_SL"])"),
                Catch::Contains ("is not the number of a case") && Catch::Contains ("'fingers.1.level_dB_SL'"));
    writeWholeFile (folder.path() / "focus.json", R"({"schema": "antinode.sweep/1", "focus": "demonstrator",
        "record": ["v_score"], "latency_ms": 5})");
    CHECK_THAT (errorText ([&] { loadSweep (folder.path() / "focus.json"); }), Catch::Contains ("is of waveforms"));
}

TEST_CASE ("Devices are a dimension of a plan, which keeps them", "[sweep][tracks]")
{
    const TemporaryFolder folder;
    auto thick = loadDocument (LibraryKind::device, "beam");
    thick["thickness_mm"] = 2 * thick["thickness_mm"].get<double>();
    writeWholeFile (folder.path() / "thick.json", thick.dump());
    const auto inputs =
        inputsOfWaveforms (folder, recorded + R"(, "vary": [{"key": "device", "values": ["beam", "./thick.json"]},
                                         {"key": "waveforms.tracks.0.level_um", "values": [0.1, 0.2]}])");
    const auto own = inputsOfWaveforms (folder, recorded + R"(, "device": "./thick.json")");
    std::filesystem::remove (folder.path() / "thick.json");
    const CaseEvaluator evaluator (inputs, false);
    evaluator.check();
    const auto beam = evaluator.evaluate (0), thicker = evaluator.evaluate (2);
    REQUIRE (thicker.error.empty());
    CHECK (thicker.values == CaseEvaluator (own, false).evaluate (0).values);
    CHECK (thicker.values[0] != beam.values[0]);

    // Written and read again it is the same plan.
    CHECK (sweepInputs (inputs.document, "elsewhere/plan.json").hash == inputs.hash);
}
