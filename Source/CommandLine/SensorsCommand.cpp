#include "Commands.h"
#include "CommonOptions.h"
#include "Progress.h"
#include "SensorsOnDevice.h"

#include <antinode_base/Prefixes.h>
#include <antinode_library/Inputs.h>

#include <cstdio>
#include <memory>
#include <string>

namespace antinode
{
namespace
{
struct SensorsOptions
{
    std::string focus = "demonstrator", device, folder = "antinode-sensors";
    std::vector<std::string> assignments;
    SensorRequest request;
    bool isQuiet = false;
};

void print (const SensorsOptions& options, const ModalModel& model, const SensorPlaces& places)
{
    std::printf ("%s on %s\n  %6s %10s %10s %16s\n", places.focus.c_str(), places.device.c_str(), "sensor", "x (mm)",
                 "y (mm)", "together (bits)");

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
    {
        const Eigen::Vector2d place = milli * sensorPlace (model, places, i);
        const auto ceramic = chosenCeramic (places, i);
        std::printf ("  %6zu %10.2f %10.2f %16.1f%s\n", i + 1, place.x(), place.y(), places.choice.bits[i],
                     ceramic > 0 ? ("  idle ceramic " + std::to_string (ceramic)).c_str() : "");
    }

    std::printf ("  at random places: %.1f bits (median)\nPlaces: %s/sensors.csv; report: %s/report.html\n",
                 places.randomBits, options.folder.c_str(), options.folder.c_str());
}

void chooseSensorPlaces (const SensorsOptions& options)
{
    checkAssignments (options.assignments);
    const auto device =
        loadDevice (deviceFor (LibraryKind::focus, { options.focus }, options.device, usualDevice, options.assignments),
                    options.assignments);
    const auto focus = loadFocus (options.focus, options.assignments);
    Progress progress (options.isQuiet);
    const auto found = sensorsOnDevice (device, focus, options.request,
                                        [&] (const std::string& what, double share) { progress.show (what, share); });
    writeSensors (options.folder, found.model, found.places);

    if (! options.isQuiet)
        print (options, found.model, found.places);
}
} // namespace

void addSensorsCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("sensors", "Chooses where sensors tell most of the modes that a focus plays");
    auto options = std::make_shared<SensorsOptions>();
    auto& request = options->request;
    command->add_option ("focus", options->focus, "Focus: an embedded name or a .json file")->capture_default_str();
    command->add_option ("--device", options->device,
                         "Device: an embedded name or a .json file (default: the one that the focus names, else "
                         "staple)");
    command->add_option ("--count", request.count, "How many sensors")
        ->check (CLI::Range (1, 100))
        ->capture_default_str();
    command
        ->add_option ("--idle-ceramic", request.idleCeramics,
                      "Ceramic that is not driven and may be one of the sensors, counted from 1 (repeatable)")
        ->allow_extra_args (false)
        ->check (CLI::Range (1, 4096));
    command->add_option ("--candidates", request.candidates, "About how many places are compared, in square cells")
        ->check (CLI::Range (1, 100000))
        ->capture_default_str();
    const auto add = [&] (const char* name, double& value, const char* text)
    { command->add_option (name, value, text)->check (CLI::Range (0.0, 50.0))->capture_default_str(); };
    add ("--frequency-percent", request.frequency, "Standard deviation of each frequency from the device, %");
    add ("--damping-percent", request.damping, "Standard deviation of each damping ratio, %");
    add ("--participation-percent", request.participation, "Standard deviation of each participation, %");
    command->add_option ("--snr-db", request.signalToNoise, "Signal-to-noise ratio at an average place, dB")
        ->check (CLI::Range (-20.0, 300.0))
        ->capture_default_str();
    command->add_option ("--rate", request.rate, "Sample rate, Hz")->type_name ("FLOAT")->capture_default_str();
    command->add_option ("--duration-ms", request.duration, "Length of the play, ms")
        ->check (CLI::Range (1.0, 10000.0))
        ->capture_default_str();
    command
        ->add_option ("--set", options->assignments,
                      "Overrides a key, for example focus.targets.0.x_mm=24 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    addCacheFlag (*command, request.usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { chooseSensorPlaces (*options); });
}
} // namespace antinode
