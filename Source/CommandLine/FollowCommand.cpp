#include "Commands.h"
#include "CommonOptions.h"
#include "FollowFiles.h"
#include "FollowOnDevice.h"
#include "LearnFiles.h"
#include "Progress.h"

#include <antinode_library/Inputs.h>
#include <antinode_responses/PointsFile.h>

#include <cstdio>
#include <memory>

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
    FollowRequest request;
    bool isQuiet = false;
};

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
    const auto device = loadDevice (options.device, options.assignments);
    auto request = options.request;

    if (! options.pointsFile.empty())
        request.places = readPointsFile (options.pointsFile);

    Progress progress (options.isQuiet);
    const auto followed = followOnDevice (
        device, request,
        [&] (const ModalModel& known, Eigen::Index sensors)
        { return readPlayedRecording (options.recorded, known, sensors, options.sensor); },
        [&] (const std::string& what, double share) { progress.show (what, share); });
    writeDrift (options.folder, followed);

    if (! options.isQuiet)
        print (options, followed.nominal, followed.trace);
}

void addDriftOptions (CLI::App& command, FollowRequest& request)
{
    const auto add = [&] (const char* name, double& value, double most, const char* text)
    { command.add_option (name, value, text)->check (CLI::Range (0.0, most))->capture_default_str(); };
    add ("--drift-percent", request.drift, 10, "Standard deviation of what all frequencies share, %");
    add ("--scatter-percent", request.scatter, 10, "Standard deviation of each frequency beside it, %");
    add ("--damping-percent", request.damping, 50, "Standard deviation of each damping ratio, %");
    add ("--gain-percent", request.gain, 50, "Standard deviation of what a sensor hears of each mode, %");
    add ("--jump-percent", request.largestJump, 10, "Largest jump of all frequencies that is searched for, %");
    command
        .add_option (
            "--feedthrough", request.feedthrough,
            "Standard deviation of what the sensors hear of each voltage's slope, in their unit per V/s (default: "
            "that of modes above those of the model)")
        ->check (CLI::Range (0.0, 1.0));
    add ("--window-s", request.window, 60, "Length of what is compared at once, s");
    add ("--memory-s", request.memory, 10, "Before each window: for how long the slowest mode remembers, s");
}
} // namespace

void addFollowCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("follow", "Follows the drift of a device from a recording of whatever was played on it");
    auto options = std::make_shared<FollowOptions>();
    auto& request = options->request;
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
        ->add_option ("--idle-ceramic", request.idleCeramic,
                      "Ceramic that is not driven and whose current is the last channel, counted from 1; 0: none")
        ->check (CLI::Range (0, 4096))
        ->capture_default_str();
    command->add_option ("--latency-ms", request.latency, "Latency of the recording, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str();
    command->add_option ("--snr-db", request.signalToNoise, "Signal-to-noise ratio of the sensors, dB")
        ->check (CLI::Range (-20.0, 300.0))
        ->capture_default_str();
    addSensorOptions (*command, options->sensor);
    addDriftOptions (*command, request);
    command
        ->add_option ("--set", options->assignments, "Overrides a key, for example device.modes.count=40 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    addCacheFlag (*command, request.usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { follow (*options); });
}
} // namespace antinode
