#include "Support/ClosedFormResponse.h"
#include "Support/RunProgram.h"

#include <antinode_audio/AudioTypes.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_learning/ChooseSensors.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

namespace
{
/** Arguments of a short measurement of the embedded beam. */
ProgramArguments shortly (ProgramArguments arguments)
{
    for (const auto* const each : { "--device", "beam", "--rate", "24000", "--highest-hz", "8000", "--resolution-hz",
                                    "4", "--periods", "2", "--settling", "2" })
        arguments.emplace_back (each);

    return arguments;
}

/** The largest effective error of all responses of a file to the beam's closed form, over the response. */
double worstError (const std::filesystem::path& file, const std::vector<double>& places)
{
    const auto beam = solveStructure (loadDevice ("beam", {}));
    const auto responses = mergedResponses ({ readMeasurement (file, CsvForm::byHeadings) }, {}).responses;
    REQUIRE (responses.values.size() == 6);
    REQUIRE (responses.points.rows() == std::ssize (places));
    double worst = 0;

    for (Eigen::Index ceramic = 0; ceramic < 6; ++ceramic)
        for (std::size_t p = 0; p < places.size(); ++p)
        {
            const auto right = test::closedForm (beam, shapesAt (beam, places[p], 0), ceramic, responses.frequencies);
            const Eigen::VectorXcd error =
                responses.values[static_cast<std::size_t> (ceramic)].col (static_cast<Eigen::Index> (p)) - right;
            worst = std::max (worst, error.norm() / right.norm());
        }

    return worst;
}

/** A recorder that was started a while before the excitation: two sensors and the sync channel. */
void recordOnBench (const std::filesystem::path& excitationFolder, const std::filesystem::path& file,
                    const std::vector<double>& places)
{
    const auto beam = solveStructure (loadDevice ("beam", {}));
    const auto played = readWaveFile (excitationFolder / "excitation.wav");
    Eigen::MatrixXd shapes (std::ssize (places), beam.modes());

    for (std::size_t p = 0; p < places.size(); ++p)
        shapes.row (static_cast<Eigen::Index> (p)) = shapesAt (beam, places[p], 0);

    SimulatedBenchSettings bench;
    bench.sampleRate = played.sampleRate;
    const auto recording = simulateBench (beam, shapes, played.samples.topRows (6) * beam.fullScaleVoltage,
                                          played.samples.row (6).transpose(), bench);
    constexpr Eigen::Index before = 7777;
    Eigen::MatrixXd channels = Eigen::MatrixXd::Zero (shapes.rows() + 1, before + played.samples.cols());
    channels.topRightCorner (shapes.rows(), played.samples.cols()) = recording.sensors;
    channels.bottomRightCorner (1, played.samples.cols()) = recording.sync.transpose() * 0.3;
    writeWholeFile (file, encodeWave (channels, 1, played.sampleRate));
}
} // namespace

TEST_CASE ("What excite writes and a recorder records frf turns into the responses of the device", "[command line]")
{
    const TemporaryFolder folder;
    const auto path = folder.path();
    auto run = runProgram (shortly ({ "excite", "--level-v", "10", "--out", (path / "ex").string() }));
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("6 ceramics and a sync channel") != std::string::npos);
    const auto played = readWaveFile (path / "ex" / "excitation.wav").samples;
    CHECK (played.rows() == 7);
    CHECK (played.topRows (6).cwiseAbs().maxCoeff() <= 10.0 / 150 * (1 + 1e-6));

    recordOnBench (path / "ex", path / "a.wav", { -0.061, 0.033 });
    run = runProgram ({ "frf", (path / "ex" / "excitation.json").string(), (path / "a.wav").string(), "--out",
                        (path / "a.uff").string(), "--sensitivity-mm-s-per-v", "1000", "--report",
                        (path / "report").string() });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (worstError (path / "a.uff", { -0.061, 0.033 }) < 0.01);
    CHECK (readContent (path / "report" / "report.html").find ("Signal-to-noise ratio of each point")
           != std::string::npos);

    run = runProgram ({ "frf", (path / "ex" / "excitation.json").string(), (path / "a.wav").string(), "--out",
                        (path / "b.uff").string(), "--sensitivity-mm-s-per-v", "1000", "--sync-channel", "1" });
    CHECK (run.exitCode == 1);
    CHECK (run.errors.find ("sync channel: does not contain the excitation signal") != std::string::npos);
    CHECK_FALSE (std::filesystem::exists (path / "b.uff"));
}

TEST_CASE ("measure --simulate measures the device, keeps what is finished and goes on with the rest", "[command line]")
{
    const TemporaryFolder folder;
    const auto out = folder.path() / "out";
    writeWholeFile (folder.path() / "points.csv", "x_mm,y_mm\n-61,0\n33,0\n70,0\n");
    const auto arguments = shortly ({ "measure", "--simulate", "--snr-db", "60", "--points",
                                      (folder.path() / "points.csv").string(), "--out", out.string() });
    auto run = runProgram (arguments);
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("level check: at most") != std::string::npos);
    CHECK (worstError (out / "responses.uff", { -0.061, 0.033, 0.070 }) < 0.003);

    const auto whole = readContent (out / "responses.uff");
    std::filesystem::remove (out / "responses.uff");
    std::filesystem::remove (out / "point-0003.uff");
    run = runProgram (arguments);
    CHECK (run.exitCode == 0);
    CHECK (run.output.find ("coherence") != std::string::npos);
    CHECK (readContent (out / "responses.uff").size() == whole.size());

    auto others = arguments;
    others.insert (others.end(), { "--level-v", "5" });
    run = runProgram (others);
    CHECK (run.exitCode == 1);
    CHECK (run.errors.find ("contains a measurement with another excitation or other points") != std::string::npos);
}

TEST_CASE ("retune finds a drift from three points", "[command line]")
{
    const TemporaryFolder folder;
    const auto out = folder.path() / "out";
    writeWholeFile (folder.path() / "points.csv", "x_mm,y_mm\n-61,0\n33,0\n70,0\n");
    // A modulus 1 % lower: frequencies fall by a little less than half a per cent, as ceramics stay.
    auto drifted = loadDeviceDocument (
        "beam", { "device.material={\"youngs_modulus_GPa\": 69.3, \"poisson_ratio\": 0.33, \"density_kg_m3\": 2700}" });
    writeWholeFile (folder.path() / "drifted.json", drifted.dump());
    auto run =
        runProgram (shortly ({ "measure", "--simulate", "--simulated-device", (folder.path() / "drifted.json").string(),
                               "--points", (folder.path() / "points.csv").string(), "--out", out.string() }));
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    run = runProgram (
        { "retune", "beam", (out / "responses.uff").string(), "--out", (folder.path() / "retuned.json").string() });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);

    const auto retuned = solveStructure (loadDevice ((folder.path() / "retuned.json").string(), {}));
    const auto right = solveStructure (loadDevice ((folder.path() / "drifted.json").string(), {}));

    for (Eigen::Index k = 0; k < 7; ++k) // Those in the band.
        CHECK (retuned.frequencyHz (k) == Approx (right.frequencyHz (k)).epsilon (2e-5));
}

TEST_CASE ("Measurements that cannot begin say why in a line", "[command line]")
{
    const TemporaryFolder folder;
    const auto points = (folder.path() / "points.csv").string(), out = (folder.path() / "out").string();
    writeWholeFile (points, "x_mm,y_mm\n0,0\n");
    const auto measureError = [&] (ProgramArguments more)
    {
        auto arguments = shortly ({ "measure", "--points", points, "--out", out });
        arguments.insert (arguments.end(), more.begin(), more.end());
        const auto run = runProgram (arguments);
        CHECK (run.exitCode == 1);
        CHECK (std::count (run.errors.begin(), run.errors.end(), '\n') == 1);
        return run.errors;
    };
    CHECK (measureError ({}).find ("--sensitivity-mm-s-per-v: is missing") != std::string::npos);
    CHECK (measureError ({ "--simulate", "--level-v", "151" }).find ("allowed: above 0 to its limit, 150 V")
           != std::string::npos);
    CHECK (measureError ({ "--simulate", "--level-v", "5", "--level-v", "6" }).find ("once for each of the 6 ceramics")
           != std::string::npos);
    CHECK (measureError ({ "--sensitivity-mm-s-per-v", "100", "--backend", "ASIO" }).find ("does not exist")
           != std::string::npos);
    CHECK (measureError ({ "--sensitivity-mm-s-per-v", "100", "--sync-input", "1" }).find ("input 1: has two roles")
           != std::string::npos);
    writeWholeFile (points, "x_mm,y_mm\n500,0\n");
    CHECK_FALSE (measureError ({ "--simulate" }).empty());
    CHECK_FALSE (std::filesystem::exists (out));
    CHECK (runProgram ({ "measure", "--device", "beam" }).exitCode == 2);
    CHECK (runProgram ({ "frf" }).exitCode == 2);
    CHECK (runProgram ({ "excite", "--device", "beam" }).exitCode == 2);
}

TEST_CASE ("measure --checklist says what to connect and to expect, and neither plays nor starts a measurement",
           "[command line]")
{
    const TemporaryFolder folder;
    const auto out = folder.path() / "out";
    writeWholeFile (folder.path() / "points.csv", "x_mm,y_mm\n-61,0\n33,0\n70,0\n");
    const auto arguments =
        shortly ({ "measure", "--points", (folder.path() / "points.csv").string(), "--out", out.string() });
    auto asked = arguments;
    asked.insert (asked.end(), { "--checklist", "--sensor-input", "3", "--sensitivity-mm-s-per-v", "125" });
    const auto checklist = runProgram (asked);
    INFO (checklist.errors);
    REQUIRE (checklist.exitCode == 0);
    const auto text = readContent (out / "checklist.txt");
    CHECK (checklist.output.find (text) == 0);
    CHECK (text.find ("input 3: sensor, 125 mm/s per V") != std::string::npos);
    CHECK (text.find ("3 points with 1 sensor x 6 ceramics x 1.3 s") != std::string::npos);
    CHECK_FALSE (std::filesystem::exists (out / "excitation.json"));

    // What it expects of the level check at the first point is what the bench hears there. The bench delays by a
    // fraction of a sample; samples of a band up to a third of the rate miss some per cent of the peak between them.
    writeWholeFile (folder.path() / "points.csv", "x_mm,y_mm\n-61,0\n");
    auto measured = arguments;
    measured.insert (measured.end(), { "--simulate", "--snr-db", "120" });
    const auto run = runProgram (measured);
    REQUIRE (run.exitCode == 0);
    const std::string said = "level check: at most ", hoped = "level check should give about ";
    REQUIRE (run.output.find (said) != std::string::npos);
    REQUIRE (text.find (hoped) != std::string::npos);
    CHECK (std::stod (text.substr (text.find (hoped) + hoped.size()))
           == Approx (std::stod (run.output.substr (run.output.find (said) + said.size()))).epsilon (0.1));
}

TEST_CASE ("Help names the types of audio devices that this system has", "[command line]")
{
    // JUCE makes the types without asking for devices.
    juce::AudioDeviceManager manager;
    juce::OwnedArray<juce::AudioIODeviceType> made;
    manager.createAudioDeviceTypes (made);
    std::vector<std::string> names;

    for (const auto* const type : made)
        names.push_back (type->getTypeName().toStdString());

    CHECK (names == systemDeviceTypes());

    for (const auto& name : names)
        CHECK (deviceTypeHelp().find (name) != std::string::npos);

    for (const auto* const command : { "calibrate", "learn", "measure" })
        CHECK (runProgram ({ command, "--help" }).output.find (deviceTypeHelp()) != std::string::npos);
}

TEST_CASE ("places to measure lie apart on the surface, away from its edges, and hear every mode", "[command line]")
{
    for (const auto* const name : { "beam", "phone" })
    {
        const auto model = solveDevice (readDevice (loadDocument (LibraryKind::device, name), name), {}, true);
        const auto places = placesToMeasure (model, 6);
        const auto shapes = shapesAtPlaces (model, places);
        REQUIRE (places.rows() == 6);

        for (Eigen::Index p = 0; p < 6; ++p)
        {
            INFO (name << ", point " << p + 1);
            CHECK (liesOn (model.surface, places (p, 0), places (p, 1)));
            CHECK (places (p, 0) - model.surface.xMinimum > 5e-3);
            CHECK (model.surface.xMaximum - places (p, 0) > 5e-3);

            for (Eigen::Index q = 0; q < p; ++q)
                CHECK ((places.row (p) - places.row (q)).norm() > 4e-3);
        }

        // None of the modes has its nodes at all of them.
        const auto cells = squareCells (model.surface, 400).centres;
        Eigen::VectorXd squares = Eigen::VectorXd::Zero (model.modes());
        double count = 0;

        for (Eigen::Index c = 0; c < cells.rows(); ++c)
            if (liesOn (model.surface, cells (c, 0), cells (c, 1)))
            {
                squares += shapesAtPlaces (model, cells.row (c)).cwiseAbs2().transpose();
                ++count;
            }

        const Eigen::VectorXd heard = shapes.cwiseAbs().colwise().maxCoeff().transpose();

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            CHECK (heard[k] > 0.3 * std::sqrt (squares[k] / count));
    }
}
