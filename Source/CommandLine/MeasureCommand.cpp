#include "Commands.h"
#include "ExcitationOptions.h"
#include "MeasurementReport.h"
#include "Measuring.h"
#include "SensorOptions.h"
#include "SimulatedBenchPlayer.h"

#include <antinode_files/PointsFile.h>
#include <antinode_files/UniversalFile.h>
#include <antinode_files/UniversalResponses.h>
#include <antinode_model/InputError.h>

#include <memory>

namespace antinode
{
namespace
{
struct MeasureOptions
{
    ExcitationOptions excitation;
    std::string pointsFile, folder;
    bool isSimulated = false, asksNothing = false;
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

void measure (const MeasureOptions& options)
{
    const auto model = excitedDevice (options.excitation);
    const auto sheet = excitationFor (model, options.excitation);
    const auto points = readPointsFile (options.pointsFile);
    const auto bench = simulatedBench (options, model, points);
    const MeasurementFolder folder (options.folder, sheet, points);
    const auto measurement =
        measurePoints (*bench, sheet, points, folder, PointGuide (options.isSimulated || options.asksNothing), {});

    OutputFolder output (options.folder);
    output.write ("responses.uff", encodeUniversalFile (responseSets (measurement.responses)));
    output.write ("report.html", renderReport (measurementReport (measurement, sheet)));
    output.commit();
    printMeasurement (measurement, sheet);
    std::printf ("Responses and pictures: %s/responses.uff, report.html\n", options.folder.c_str());
}

void addSimulationOptions (CLI::App& command, MeasureOptions& options)
{
    auto* const simulate =
        command.add_flag ("--simulate", options.isSimulated,
                          "Measures on a bench that is not there: the device's modes, noise and delay");
    command
        .add_option ("--simulated-device", options.simulatedDevice, "The device on that bench, where it is another one")
        ->needs (simulate);
    command.add_option ("--snr_dB", options.simulation.signalToNoise, "Its signal over its noise")
        ->check (CLI::Range (-20.0, 300.0))
        ->needs (simulate)
        ->capture_default_str();
    command.add_option ("--delay_ms", options.simulatedDelay, "Its latency")
        ->check (CLI::Range (0.0, 200.0))
        ->needs (simulate)
        ->capture_default_str();
    command.add_option ("--cubic_percent", options.simulatedCubic, "Its cubic nonlinearity at full level")
        ->check (CLI::Range (-20.0, 20.0))
        ->needs (simulate)
        ->capture_default_str();
}
} // namespace

void addMeasureCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("measure", "Plays, records and turns into frequency responses, point by point");
    auto options = std::make_shared<MeasureOptions>();
    addExcitationOptions (*command, options->excitation);
    command->add_option ("--points", options->pointsFile, "CSV of the points, x and y in mm")
        ->required()
        ->type_name ("FILE");
    command
        ->add_option ("--out", options->folder, "Folder of the measurement; one that was interrupted is gone on with")
        ->required()
        ->type_name ("DIR");
    command->add_flag ("--no-questions", options->asksNothing, "Measures all points as they come");
    addSimulationOptions (*command, *options);
    command->callback ([options] { measure (*options); });
}
} // namespace antinode
