#include "Support/RunProgram.h"

#include <antinode_base/MessageText.h>
#include <antinode_documents/Inputs.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <random>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

namespace
{
constexpr double rate = 48000;
constexpr Eigen::Index samples = 4 * 48000, silence = 65000;

/** Thin and soldered: then all modes of the beam drift nearly alike with its modulus. */
std::vector<std::string> thinAndSoldered()
{
    std::vector<std::string> assignments { "device.theory=euler_bernoulli" };

    for (int i = 0; i < 6; ++i)
        assignments.push_back (formatted ("device.ceramics.%d.glue=rigid", i));

    return assignments;
}

/** The embedded beam with a modulus that is .2 % lower: frequencies are .08 to .09 % lower, as the ceramics stay. */
ModalModel driftedBeam()
{
    auto assignments = thinAndSoldered();
    assignments.emplace_back (
        R"(device.material={"youngs_modulus_GPa": 69.86, "poisson_ratio": 0.33, "density_kg_m3": 2700})");
    return solveStructure (loadDevice ("beam", assignments));
}

/** Silence over the first of three windows, then noise on all ceramics up to half the rate. */
Eigen::MatrixXd played (const ModalModel& model)
{
    std::mt19937 random (1);
    std::normal_distribution<double> normal (0, 0.1 * model.fullScaleVoltage);
    Eigen::MatrixXd voltages (model.actuators(), samples);

    for (Eigen::Index i = 0; i < samples; ++i)
        for (Eigen::Index b = 0; b < voltages.rows(); ++b)
            voltages (b, i) = i < silence ? 0 : normal (random);

    return voltages;
}

/** voltages.wav, recorded.csv of two sensors, and where they are. */
void writeRecording (const std::filesystem::path& folder, bool isSwapped)
{
    const auto truth = driftedBeam();
    const auto voltages = played (truth);
    Eigen::MatrixXd shapes (2, truth.modes());
    shapes << shapesAt (truth, -0.061, 0), shapesAt (truth, 0.033, 0);

    if (isSwapped)
        shapes.row (0).swap (shapes.row (1));

    SimulatedBenchSettings bench;
    bench.sampleRate = rate;
    bench.delay = 0.002;
    const auto recording = simulateBench (truth, shapes, voltages, Eigen::VectorXd::Ones (samples), bench);
    writeWholeFile (folder / "voltages.wav", encodeWave (voltages, truth.fullScaleVoltage, rate));
    writeWholeFile (folder / "recorded.csv",
                    encodeCsv (1000 * recording.sensors, { "velocity_mm_s_1", "velocity_mm_s_2" }, rate, 0));
    writeWholeFile (folder / "sensors.csv", "x_mm,y_mm\n-61,0\n33,0\n");
}

ProgramArguments followArguments (const std::filesystem::path& folder)
{
    ProgramArguments arguments { "follow",       "beam",
                                 "--set",        "device.limits.requires_arming=true",
                                 "--recorded",   folder.string(),
                                 "--out",        (folder / "drift").string(),
                                 "--sensors",    (folder / "sensors.csv").string(),
                                 "--latency-ms", "2" };

    for (const auto& assignment : thinAndSoldered())
        arguments.insert (arguments.end(), { "--set", assignment });

    return arguments;
}

nlohmann::json summaryOf (const std::filesystem::path& folder)
{
    return nlohmann::json::parse (readContent (folder / "drift" / "summary.json"));
}
} // namespace

TEST_CASE ("follow tells the drift of a beam from noise that was played on it", "[command line]")
{
    const TemporaryFolder folder;
    writeRecording (folder.path(), false);
    const auto run = runProgram (followArguments (folder.path()));
    INFO (run.errors << run.output);
    REQUIRE (run.exitCode == 0);

    const auto summary = summaryOf (folder.path());
    CHECK (summary["windows_silent"] == 1);
    CHECK (summary["windows_lost"] == 0);
    CHECK (summary["common_ppm"] > -920);
    CHECK (summary["common_ppm"] < -770);

    // 50 ppm are what designs notice.
    const auto device = loadDevice ((folder.path() / "drift" / "device.json").string(), {});
    CHECK (device.requiresArming);
    const auto followed = solveStructure (device);
    const auto right = driftedBeam();

    for (Eigen::Index k = 0; k < followed.modes(); ++k)
        CHECK (followed.frequencyHz (k) == Approx (right.frequencyHz (k)).epsilon (5e-5));
}

TEST_CASE ("follow learns nothing where sensors are swapped, and asks for a sensor", "[command line]")
{
    const TemporaryFolder folder;
    writeRecording (folder.path(), true);
    auto run = runProgram (followArguments (folder.path()));
    CHECK (run.exitCode == 0);
    const auto summary = summaryOf (folder.path());
    CHECK (summary["windows_followed"] == 0);
    CHECK (summary["common_ppm"] == 0);

    run = runProgram ({ "follow", "beam", "--recorded", folder.path().string() });
    CHECK (run.exitCode == 1);
    CHECK (run.errors.find ("follow: has no sensor; allowed: --sensors, --idle-ceramic or both") != std::string::npos);
}
