#include "Commands.h"
#include "CommonOptions.h"
#include "FocusOnDevice.h"
#include "FollowFiles.h"
#include "LearnFiles.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_learning/LowerRate.h>
#include <antinode_library/Inputs.h>
#include <antinode_model/ShapesAtPlaces.h>
#include <antinode_responses/PointsFile.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

namespace antinode
{
namespace
{
constexpr double hundred = 100, million = 1e6;

struct FollowOptions
{
    std::string device, recorded, folder = "antinode-drift", pointsFile;
    std::vector<std::string> assignments;
    SensorOptions sensor;
    int idleCeramic = 0;                                                               // counted from 1; 0: none
    double latency = 0, signalToNoise = 40, window = 1, memory = 0.3, largestJump = 2; // ms, dB, s, s, %
    double drift = 0.5, scatter = 0.1, damping = 10, gain = 5;                         // %
    std::optional<double> feedthrough; // the sensor's unit per V/s; none: as much as of modes
    bool usesCache = true, isQuiet = false;
};

/** The places of the velocity sensors, 0 x 2 where there are none. */
Eigen::MatrixX2d sensorPlaces (const FollowOptions& options)
{
    return options.pointsFile.empty() ? Eigen::MatrixX2d (0, 2) : readPointsFile (options.pointsFile);
}

Eigen::Index sensorCount (const FollowOptions& options, const ModalModel& model)
{
    if (options.idleCeramic > model.actuators())
        throw InputError ("--idle-ceramic", "is " + std::to_string (options.idleCeramic) + "; allowed: 1 to "
                                                + std::to_string (model.actuators()));

    const auto count = sensorPlaces (options).rows() + (options.idleCeramic > 0 ? 1 : 0);

    if (count == 0)
        throw InputError ("follow", "has no sensor; allowed: --sensors, --idle-ceramic or both");

    return count;
}

std::vector<Sensor> sensorsOf (const FollowOptions& options, const ModalModel& model)
{
    std::vector<Sensor> sensors;

    const auto shapes = shapesAtPlaces (model, sensorPlaces (options));

    for (Eigen::Index m = 0; m < shapes.rows(); ++m)
        sensors.push_back ({ shapes.row (m), 0 });

    // By reciprocity an idle ceramic's current.
    if (options.idleCeramic > 0)
        sensors.push_back ({ model.participation.col (options.idleCeramic - 1).transpose(), 0 });

    return sensors;
}

DriftSettings settingsOf (const FollowOptions& options, const ModalModel& model, const std::vector<Sensor>& sensors)
{
    DriftSettings settings;
    settings.spread.drift = options.drift / hundred;
    settings.spread.frequency = options.scatter / hundred;
    settings.spread.damping = options.damping / hundred;
    settings.spread.gain = options.gain / hundred;
    settings.spread.feedthrough = options.feedthrough.value_or (usualFeedthrough (model, sensors));
    settings.memory = options.memory;
    settings.largestJump = options.largestJump / hundred;
    return settings;
}

void print (const FollowOptions& options, const ModalModel& nominal, const DriftTrace& trace)
{
    std::printf ("%s\n  %10s %10s %14s %16s\n", nominal.name.c_str(), "time (s)", "state", "common (ppm)",
                 "unexplained (%)");

    for (const auto& moment : trace.moments)
        std::printf ("  %10.2f %10s %14.1f %16.2f  %s\n", moment.time, driftStateWord (moment.state),
                     million * moment.common, hundred * moment.unexplained, moment.reason.c_str());

    std::printf ("The device as it is now: %s/device.json; report: %s/report.html\n", options.folder.c_str(),
                 options.folder.c_str());
}

void follow (const FollowOptions& options)
{
    checkAssignments (options.assignments);
    Progress progress (options.isQuiet);
    progress.show ("Modes of the device", 0);
    const auto device = loadDevice (options.device, options.assignments);
    const auto known = solveDevice (device, {}, options.usesCache);
    auto recording = readPlayedRecording (options.recorded, known, sensorCount (options, known), options.sensor);
    const auto wide =
        wideOf (device, known, { Reconstruction::bandLimited, recording.sampleRate }, options.usesCache).model;
    const auto nominal = modesWithin (wide, recording.sampleRate);
    const auto sensors = sensorsOf (options, nominal);
    recording.noise = noiseOfRecording (recording.signals, options.signalToNoise);
    recording.delay = options.latency / 1000;

    // A ceramic that listens is not driven, whatever its channel says.
    if (options.idleCeramic > 0)
        recording.voltages.row (options.idleCeramic - 1).setZero();

    const auto trace = followRecording (nominal, sensors, recording, settingsOf (options, nominal, sensors),
                                        options.window, [&] (double share) { progress.show ("Following", share); });
    writeDrift (options.folder, nominal, std::min (known.modes(), nominal.modes()), trace);

    if (! options.isQuiet)
        print (options, nominal, trace);
}

void addDriftOptions (CLI::App& command, FollowOptions& options)
{
    const auto add = [&] (const char* name, double& value, double most, const char* text)
    { command.add_option (name, value, text)->check (CLI::Range (0.0, most))->capture_default_str(); };
    add ("--drift-percent", options.drift, 10, "Standard deviation of what all frequencies share, %");
    add ("--scatter-percent", options.scatter, 10, "Standard deviation of each frequency beside it, %");
    add ("--damping-percent", options.damping, 50, "Standard deviation of each damping ratio, %");
    add ("--gain-percent", options.gain, 50, "Standard deviation of what a sensor hears of each mode, %");
    add ("--jump-percent", options.largestJump, 10, "Largest jump of all frequencies that is searched for, %");
    command
        .add_option (
            "--feedthrough", options.feedthrough,
            "Standard deviation of what the sensors hear of each voltage's slope, in their unit per V/s (default: "
            "that of modes above those of the model)")
        ->check (CLI::Range (0.0, 1.0));
    add ("--window-s", options.window, 60, "Length of what is compared at once, s");
    add ("--memory-s", options.memory, 10, "Before each window: for how long the slowest mode remembers, s");
}
} // namespace

void addFollowCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("follow", "Follows the drift of a device from a recording of whatever was played on it");
    auto options = std::make_shared<FollowOptions>();
    command->add_option ("device", options->device, "Device before the drift: an embedded name or a .json file")
        ->required();
    command
        ->add_option ("--recorded", options->recorded,
                      "Folder with voltages.wav and with recorded.csv or recorded.wav of the sensors")
        ->required()
        ->type_name ("FOLDER");
    command->add_option ("--sensors", options->pointsFile, "CSV of x and y, mm: the places of the velocity sensors")
        ->type_name ("POINTS.csv");
    command
        ->add_option ("--idle-ceramic", options->idleCeramic,
                      "Ceramic that is not driven and whose current is the last channel, counted from 1; 0: none")
        ->check (CLI::Range (0, 4096))
        ->capture_default_str();
    command->add_option ("--latency-ms", options->latency, "Latency of the recording, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str();
    command->add_option ("--snr-db", options->signalToNoise, "Signal-to-noise ratio of the sensors, dB")
        ->check (CLI::Range (-20.0, 300.0))
        ->capture_default_str();
    addSensorOptions (*command, options->sensor);
    addDriftOptions (*command, *options);
    command
        ->add_option ("--set", options->assignments, "Overrides a key, for example device.modes.count=40 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    addCacheFlag (*command, options->usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { follow (*options); });
}
} // namespace antinode
