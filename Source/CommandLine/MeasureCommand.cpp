#include "AudioBenchOptions.h"
#include "Commands.h"
#include "ExcitationOptions.h"
#include "FocusOnDevice.h"
#include "MeasuredFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_bench/Checklist.h>
#include <antinode_bench/Measuring.h>
#include <antinode_bench/SimulatedBenchPlayer.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_text/OutputFolder.h>

#include <memory>

namespace antinode
{
namespace
{
struct MeasureOptions
{
    ExcitationOptions excitation;
    std::string pointsFile, folder;
    bool isSimulated = false, asksNoQuestions = false, onlyChecks = false;
    AudioBenchOptions audio;
    double latency = 0; // ms
    std::string simulatedDevice;
    SimulatedBenchSettings simulation;
    double simulatedDelay = 1.234567; // ms
    double simulatedCubic = 0;        // %
};

std::unique_ptr<Bench> simulatedBench (const MeasureOptions& options, const ModalModel& model,
                                       const Eigen::MatrixX2d& points)
{
    auto settings = options.simulation;
    settings.delay = options.simulatedDelay / 1000;
    settings.cubic = options.simulatedCubic / 100;

    if (options.simulatedDevice.empty())
        return std::make_unique<SimulatedBenchPlayer> (model, points, settings);

    auto other = options.excitation;
    other.device = options.simulatedDevice;
    other.assignments.clear();
    return std::make_unique<SimulatedBenchPlayer> (excitedDevice (other), points, settings);
}

void writeChecklist (const MeasureOptions& options, const ModalModel& model, const ExcitationSheet& sheet,
                     const Eigen::MatrixX2d& points)
{
    const auto text = benchChecklist (model, sheet, points, benchChannels (options.audio, model.actuators()),
                                      { options.audio.sensor.sensitivity, options.audio.sensor.inputFullScale });
    OutputFolder output (options.folder);
    output.write ("checklist.txt", text);
    output.commit();
    std::printf ("%sIn %s/checklist.txt\n", text.c_str(), options.folder.c_str());
}

void measure (const MeasureOptions& options)
{
    const auto model = excitedDevice (options.excitation);
    const auto sheet = excitationFor (model, options.excitation);
    const auto points = readPointsFile (options.pointsFile);
    checkKindOfPlaces (model, points, "point");

    if (options.onlyChecks)
    {
        writeChecklist (options, model, sheet, points);
        return;
    }

    const auto bench = options.isSimulated ? simulatedBench (options, model, points)
                                           : openAudioBench (options.audio, model, options.excitation.rate);
    const MeasurementFolder folder (options.folder, sheet, points);
    RunAnalysisSettings analysis;
    analysis.latency = options.latency / 1000 * options.excitation.rate;
    const auto measurement = measurePoints (*bench, sheet, points, folder,
                                            PointGuide (options.isSimulated || options.asksNoQuestions), analysis);

    writeMeasured (options.folder, measurement, sheet);
    printMeasurement (measurement, sheet);
    std::printf ("Responses and figures: %s/responses.uff, report.html\n", options.folder.c_str());
}

void addSimulationOptions (CLI::App& command, MeasureOptions& options)
{
    auto* const simulate = command.add_flag ("--simulate", options.isSimulated,
                                             "Measures on a simulated bench with the device's modes, noise and delay");
    command
        .add_option ("--simulated-device", options.simulatedDevice,
                     "Device on the simulated bench; default: the same device")
        ->needs (simulate);
    command
        .add_option ("--snr-db", options.simulation.signalToNoise, "Signal-to-noise ratio of the simulated bench, dB")
        ->check (CLI::Range (-20.0, 300.0))
        ->needs (simulate)
        ->capture_default_str();
    command.add_option ("--delay-ms", options.simulatedDelay, "Latency of the simulated bench, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->needs (simulate)
        ->capture_default_str();
    command
        .add_option ("--cubic-percent", options.simulatedCubic,
                     "Cubic distortion of the simulated bench at full level, %")
        ->check (CLI::Range (-20.0, 20.0))
        ->needs (simulate)
        ->capture_default_str();
}
} // namespace

void addMeasureCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("measure", "Measures frequency responses point by point: plays, records and analyses");
    auto options = std::make_shared<MeasureOptions>();
    addExcitationOptions (*command, options->excitation);
    command->add_option ("--points", options->pointsFile, "CSV of the points, x and y in mm")
        ->required()
        ->type_name ("FILE");
    command->add_option ("--out", options->folder, "Folder of the measurement; an interrupted measurement is resumed")
        ->required()
        ->type_name ("DIR");
    command->add_flag (
        "--checklist", options->onlyChecks,
        "Writes what to connect, to check and to expect for this device and these points, plays nothing");
    command->add_flag ("--no-questions", options->asksNoQuestions, "Measures all points without asking");
    addAudioBenchOptions (*command, options->audio);
    addSensorOptions (*command, options->audio.sensor);
    command->add_option ("--latency-ms", options->latency, "Latency of the sensors without a sync input, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str();
    addSimulationOptions (*command, *options);
    command->callback ([options] { measure (*options); });
}
} // namespace antinode
