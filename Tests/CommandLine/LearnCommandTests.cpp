#include "Support/RunProgram.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_focus/Detuning.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

namespace
{
constexpr double learnRate = 48000;

/** `antinode learn` on the embedded beam with sensors at three places. */
ProgramArguments learnArguments (const std::filesystem::path& folder, const std::string& out,
                                 const ProgramArguments& more)
{
    ProgramArguments arguments {
        "learn", "demonstrator",         "--device", "beam",      "--rate",
        "48000", "--duration-ms",        "100",      "--sensors", (folder / "sensors.csv").string(),
        "--out", (folder / out).string()
    };
    arguments.insert (arguments.end(), more.begin(), more.end());
    return arguments;
}

void writeSensors (const std::filesystem::path& folder)
{
    writeWholeFile (folder / "sensors.csv", "x_mm,y_mm\n-61,0\n33,0\n70,0\n");
}

/** The embedded beam with a modulus that is 1 % lower. */
DeviceDescription softerBeam()
{
    return loadDevice (
        "beam", { "device.material={\"youngs_modulus_GPa\": 69.3, \"poisson_ratio\": 0.33, \"density_kg_m3\": 2700}" });
}

/** By how many samples a ceramic of the beam is late where ceramics lag. */
Eigen::Index samplesLate (std::size_t ceramic)
{
    return static_cast<Eigen::Index> (ceramic % 4);
}

/** What ceramics act on where they are late: whole samples, so that no filter is needed. */
Eigen::MatrixXd comeLate (const Eigen::MatrixXd& asked)
{
    Eigen::MatrixXd late = Eigen::MatrixXd::Zero (asked.rows(), asked.cols());

    for (Eigen::Index i = 0; i < asked.rows(); ++i)
        if (const auto count = asked.cols() - samplesLate (static_cast<std::size_t> (i)); count > 0)
            late.row (i).tail (count) = asked.row (i).head (count);

    return late;
}

void writeRecording (const std::filesystem::path& pass, const Eigen::MatrixXd& velocities)
{
    writeWholeFile (
        pass / "recorded.csv",
        encodeCsv (1000 * velocities, { "velocity_mm_s_1", "velocity_mm_s_2", "velocity_mm_s_3" }, learnRate, 0));
}

/** What the three sensors record of a pass on it.
    @param scatter  of each frequency beside its drift, relative */
void recordPass (const std::filesystem::path& pass, double signalScale, bool isLate = false, double signalToNoise = 40,
                 double scatter = 0)
{
    const auto truth = detuned (solveStructure (softerBeam()), { scatter, 0, 0, 0 }, 3);
    auto wave = readWaveFile (pass / "voltages.wav");

    if (isLate)
        wave.samples = comeLate (wave.samples);

    Eigen::MatrixXd shapes (3, truth.modes());
    shapes << shapesAt (truth, -0.061, 0), shapesAt (truth, 0.033, 0), shapesAt (truth, 0.07, 0);
    SimulatedBenchSettings bench;
    bench.sampleRate = learnRate;
    bench.delay = 0.0031;
    bench.signalToNoise = signalToNoise;
    const auto recording = simulateBench (truth, shapes, truth.fullScaleVoltage * wave.samples,
                                          Eigen::VectorXd::Ones (wave.samples.cols()), bench);
    writeRecording (pass, signalScale * recording.sensors);
}
} // namespace

TEST_CASE ("learn finds the frequencies of a drifted beam from one play of a focus", "[command line]")
{
    const TemporaryFolder folder;
    writeSensors (folder.path());
    auto run = runProgram (learnArguments (folder.path(), "pass1", {}));
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    // The focus has little of modes 3 and 5: with noise of 40 dB a deviation of 4e-4 is left of their frequencies.
    recordPass (folder.path() / "pass1", 1, false, 52);
    run = runProgram (
        learnArguments (folder.path(), "pass2",
                        { "--latency-ms", "3.1", "--snr-db", "52", "--recorded", (folder.path() / "pass1").string() }));
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);

    const auto summary = nlohmann::json::parse (readContent (folder.path() / "pass2" / "summary.json"));
    CHECK (summary["is_accepted"] == true);
    CHECK (summary["passes"].size() == 1);
    const auto learnt = solveStructure (loadDevice ((folder.path() / "pass2" / "device.json").string(), {}));
    const auto right = solveStructure (softerBeam());

    // The controlled ones, which were .5 % off: a tenth of that where the focus has little of a mode.
    for (Eigen::Index k = 0; k < 6; ++k)
        CHECK (learnt.frequencyHz (k) == Approx (right.frequencyHz (k)).epsilon (5e-4));

    for (const Eigen::Index driven : { 0, 1, 3, 5 })
        CHECK (learnt.frequencyHz (driven) == Approx (right.frequencyHz (driven)).epsilon (1e-5));

    CHECK (summary["warning"] == "");
    // All are off together, as by another material. Where each has .5 % of its own, one who expects a tenth is told.
    recordPass (folder.path() / "pass1", 1, false, 52, 0.005);
    run = runProgram (learnArguments (
        folder.path(), "doubted",
        { "--latency-ms", "3.1", "--frequency-percent", "0.05", "--recorded", (folder.path() / "pass1").string() }));
    CHECK (run.exitCode == 0);
    CHECK_THAT (run.output, Catch::Contains ("A frequency is more than 6 of its standard deviations off"));
    CHECK_THAT (readContent (folder.path() / "doubted" / "report.html"),
                Catch::Contains ("deviations off the previous device"));
}

TEST_CASE ("learn knows when ceramics act that lag behind each other", "[command line][lag]")
{
    const TemporaryFolder folder;
    writeSensors (folder.path());
    auto lagging = solveStructure (loadDevice ("beam", {}));

    for (std::size_t i = 0; i < lagging.ceramics.size(); ++i)
        lagging.ceramics[i].lag.delay = static_cast<double> (samplesLate (i)) / learnRate;

    const auto device = folder.path() / "lagging.json";
    writeWholeFile (device, modalDeviceToJson (lagging, "").dump());
    const auto learn = [&] (const std::string& out, const ProgramArguments& more)
    {
        auto arguments = learnArguments (folder.path(), out, more);
        arguments[3] = device.string();
        const auto run = runProgram (arguments);
        INFO (run.errors);
        REQUIRE (run.exitCode == 0);
        return run.output;
    };
    learn ("pass1", {});
    recordPass (folder.path() / "pass1", 1, true);
    const auto said = learn ("pass2", { "--latency-ms", "3.1", "--recorded", (folder.path() / "pass1").string() });
    INFO (said);
    CHECK (said.find ("lags of ceramics: undone to") != std::string::npos);
    const auto learnt = solveStructure (loadDevice ((folder.path() / "pass2" / "device.json").string(), {}));
    const auto right = solveStructure (softerBeam());

    // They were .5 % off.
    for (Eigen::Index k = 0; k < 6; ++k)
        CHECK (learnt.frequencyHz (k) == Approx (right.frequencyHz (k)).epsilon (1e-3));

    CHECK (learnt.ceramics[1].lag.delay == Approx (lagging.ceramics[1].lag.delay));
    const auto summary = nlohmann::json::parse (readContent (folder.path() / "pass2" / "summary.json"));
    CHECK (summary["residual_of_noise"].get<double>() < 1.2);
    CHECK (summary["lag"]["late_samples"].get<int>() >= 3);
    CHECK (summary["trigger_sample"] == summary["lag"]["late_samples"]);
}

TEST_CASE ("learn changes nothing where sensors are dead or hear something else, and says what recordings lack",
           "[command line]")
{
    const TemporaryFolder folder;
    writeSensors (folder.path());
    const auto pass = folder.path() / "pass1";
    REQUIRE (runProgram (learnArguments (folder.path(), "pass1", {})).exitCode == 0);
    const auto recorded = learnArguments (folder.path(), "pass2", { "--recorded", pass.string() });
    auto run = runProgram (recorded);
    CHECK (run.exitCode == 1);
    CHECK (run.errors.find ("has neither recorded.csv nor recorded.wav") != std::string::npos);

    recordPass (pass, 1e-6);
    run = runProgram (recorded);
    INFO (run.output);
    CHECK (run.exitCode == 0);
    CHECK (run.output.find ("Nothing is changed. Sensors hear") != std::string::npos);
    CHECK (readContent (folder.path() / "pass2" / "voltages.wav") == readContent (pass / "voltages.wav"));

    const Eigen::VectorXd noise = RandomNumbers (1).normal (3 * 4800);
    writeRecording (pass, 1e-3 * noise.reshaped (3, 4800));
    run = runProgram (recorded);
    INFO (run.output);
    CHECK (run.exitCode == 0);
    CHECK (run.output.find ("Nothing is changed. The model does not explain") != std::string::npos);
    CHECK (readContent (folder.path() / "pass2" / "voltages.wav") == readContent (pass / "voltages.wav"));

    writeWholeFile (pass / "recorded.csv", "time_s,velocity_mm_s_1\n0,0\n0.0000208333,0\n");
    run = runProgram (recorded);
    CHECK (run.exitCode == 1);
    CHECK (run.errors.find ("has 1 channels; allowed: 3, one per sensor") != std::string::npos);
}

TEST_CASE ("learn plays on a simulated bench until the focus is right, and writes what it learnt as a page",
           "[command line]")
{
    const TemporaryFolder folder;
    writeSensors (folder.path());
    const auto simulated = [&] (const ProgramArguments& more)
    {
        ProgramArguments all { "--simulate", "--seed", "3", "--passes", "5", "--enough-percent", "0.3" };
        all.insert (all.end(), more.begin(), more.end());
        const auto run = runProgram (learnArguments (folder.path(), "learnt", all));
        INFO (run.errors);
        REQUIRE (run.exitCode == 0);
        return nlohmann::json::parse (readContent (folder.path() / "learnt" / "summary.json"));
    };
    const auto isLearnt = [] (const nlohmann::json& summary)
    {
        const auto& passes = summary["passes"];
        return summary["is_accepted"] == true && passes.size() > 1 && passes.size() < 5
               && passes[0]["estimated_field_error_percent"] > 1
               && passes.back()["estimated_field_error_percent"] < 0.3;
    };
    auto summary = simulated ({});
    CHECK (isLearnt (summary));
    CHECK (summary["passes"][0]["latency_ms"].get<double>() == Approx (1.234567).margin (2e-3));
    const auto page = readContent (folder.path() / "learnt" / "report.html");
    CHECK (page.find ("What the data did not determine") != std::string::npos);
    CHECK (page.find ("From play to play") != std::string::npos);

    // Without the sync input the latency is found from the signals; with an idle ceramic beside the sensors.
    summary = simulated ({ "--sync-input", "0", "--simulated-delay-ms", "9.87", "--idle-ceramic", "2" });
    CHECK (isLearnt (summary));
    CHECK (summary["passes"][0]["latency_ms"].get<double>() == Approx (9.87).margin (2e-3));
}

TEST_CASE ("learn finds how much ceramics distort, or takes them as linear where it is told to", "[command line]")
{
    const TemporaryFolder folder;
    writeSensors (folder.path());
    const auto distortions = [&] (const char* percent)
    {
        const auto run = runProgram (learnArguments (
            folder.path(), "learnt",
            { "--simulate", "--passes", "2", "--simulated-cubic-percent", "5", "--distortion-percent", percent }));
        INFO (run.errors);
        REQUIRE (run.exitCode == 0);
        return nlohmann::json::parse (readContent (folder.path() / "learnt" / "summary.json"))["ceramics"];
    };
    const auto learnt = distortions ("3");
    REQUIRE (! learnt.empty());
    auto sum = 0.0;

    // The bench has modes that the model does not have, which the deviations do not know of.
    for (const auto& ceramic : learnt)
    {
        CAPTURE (ceramic.dump());
        CHECK (ceramic["distortion_deviation_percent"] < 1);
        CHECK (ceramic["distortion_percent"].get<double>() == Approx (5).margin (2.5));
        sum += ceramic["distortion_percent"].get<double>();
    }

    CHECK (sum / static_cast<double> (learnt.size()) == Approx (5).margin (0.5));

    const auto page = readContent (folder.path() / "learnt" / "report.html");
    CHECK (page.find ("Cubic distortion of each ceramic") != std::string::npos);

    for (const auto& ceramic : distortions ("0"))
        CHECK (ceramic["distortion_percent"] == 0);
}

TEST_CASE ("learn says what it needs to play", "[command line]")
{
    const TemporaryFolder folder;
    writeSensors (folder.path());
    const auto errors = [&] (const ProgramArguments& more)
    { return runProgram (learnArguments (folder.path(), "learnt", more)).errors; };
    CHECK (errors ({ "--simulate", "--play" }).find ("allowed: one of them") != std::string::npos);
    CHECK (errors ({ "--play" }).find ("--sensor-input: is given 1 times; allowed: 3, once per sensor")
           != std::string::npos);
    CHECK (runProgram ({ "learn", "demonstrator" }).errors.find ("allowed: --sensors, --idle-ceramic or both")
           != std::string::npos);
    CHECK (errors ({ "--idle-ceramic", "99" }).find ("--idle-ceramic: is 99; allowed: 1 to") != std::string::npos);
}
