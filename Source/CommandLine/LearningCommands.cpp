#include "CommandLine.h"
#include "TaskCommand.h"

#include <antinode_base/Prefixes.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_render/FocusOutcome.h>
#include <antinode_tasks/Follow.h>
#include <antinode_tasks/LearnFiles.h>
#include <antinode_tasks/Sensors.h>

#include <cstdio>
#include <string>

namespace antinode
{
namespace
{
constexpr double hundred = 100, million = 1e6;

void printDrift (const FollowedDevice& followed, const std::string& folder)
{
    std::printf ("%s\n  %10s %10s %14s %16s\n", followed.nominal.name.c_str(), "time (s)", "state", "common (ppm)",
                 "unexplained (%)");

    for (const auto& moment : followed.trace.moments)
        std::printf ("  %10.2f %10s %14.1f %16.2f  %s\n", moment.time, driftStateWord (moment.state),
                     million * moment.common, hundred * moment.unexplained, moment.reason.c_str());

    std::printf ("The device as it is now: %s/device.json; report: %s/report.html\n", folder.c_str(), folder.c_str());
}
} // namespace

void addFollowCommand (CLI::App& app)
{
    addFolderTask (app, followText, "antinode-drift", &follow, &writeDrift, &printDrift)
        .get_option ("--recorded")
        ->required();
}

namespace
{
void printLearnt (const LearntDevice& device, const std::string& folder)
{
    const auto& [setup, settings, learnt] = device;
    std::printf ("%s on %s\n", setup.focus.name.c_str(), setup.nominal.model.name.c_str());
    std::printf ("  %-6s %22s %34s\n", "pass", "field error (estimated)", "not predicted, of the noise (nominal)");

    for (std::size_t i = 0; i < learnt.passes.size(); ++i)
        std::printf ("  %-6zu %21.2f %% %24.1f (%.1f)\n", i + 1, 100 * learnt.passes[i].estimatedError,
                     learnt.passes[i].surprise, learnt.passes[i].nominalSurprise);

    if (! learnt.passes.empty())
        std::printf ("  not explained in the end: %.2g %% of the signals, %.2f of the noise\n",
                     100 * learnt.learnt.unexplained, learnt.learnt.residual);

    if (learnt.learnt.heldBackBefore > 0)
        std::printf ("  sensors held back: %.2g %% not predicted by the others, %.2g %% by the previous device\n",
                     100 * learnt.learnt.heldBack, 100 * learnt.learnt.heldBackBefore);

    if (! learnt.refusal.empty())
        std::printf ("  %s%s\n", keptInWords (learnt).c_str(), learnt.refusal.c_str());

    if (const auto warning = warningOf (learnt); ! warning.empty())
        std::printf ("  %s\n", warning.c_str());

    if (needsLagFilters (setup.nominal.model))
        std::printf ("  lags of ceramics: %s\n", lagsInWords (learntOutputs (learnt, settings)).c_str());

    std::printf ("Next voltages and what was learnt: %s/voltages.wav, report.html\n", folder.c_str());
}

std::vector<Field> audioFields (LearnRequest& request)
{
    std::vector<Field> all {
        Field ("--play", &request.isPlayed,
               "Plays and records through an audio device: ceramics from output 1 up, sensors at --sensor-input")
            .as ({}),
        Field ("--idle-ma-per-v", &request.idleScale, "Current of an idle ceramic per volt at its input, mA per V")
            .within (1e-9, 1e9)
    };
    append (all, fields (request.wiring));
    return all;
}
} // namespace

void addLearnCommand (CLI::App& app)
{
    addFolderTask (app, learnText, "antinode-learnt", &learn, &writeLearnt, &printLearnt, &audioFields);
}

namespace
{
void printSensors (const SensorsOnDevice& found, const std::string& folder)
{
    const auto& [model, places] = found;
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
                 places.randomBits, folder.c_str(), folder.c_str());
}
} // namespace

void addSensorsCommand (CLI::App& app)
{
    const auto write = [] (const std::filesystem::path& folder, const SensorsOnDevice& found)
    { writeSensors (folder, found.model, found.places); };
    addFolderTask (app, sensorsText, "antinode-sensors", &sensors, write, &printSensors);
}
} // namespace antinode
