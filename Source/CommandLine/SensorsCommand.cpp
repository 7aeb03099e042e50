#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_base/Prefixes.h>
#include <antinode_tasks/Sensors.h>

#include <cstdio>
#include <memory>
#include <string>

namespace antinode
{
namespace
{
struct SensorsOptions
{
    SensorRequest request;
    std::filesystem::path folder = "antinode-sensors";
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
} // namespace

void addSensorsCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (sensorsText.name, sensorsText.summary);
    auto options = std::make_shared<SensorsOptions>();
    auto all = fields (options->request);
    append (all, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet) });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            Progress progress (options->isQuiet);
            const auto found = sensors (options->request, progress.shown());
            writeSensors (options->folder, found.model, found.places);

            if (! options->isQuiet)
                print (*options, found.model, found.places);
        });
}
} // namespace antinode
