#include "Commands.h"
#include "FolderTask.h"

#include <antinode_base/Prefixes.h>
#include <antinode_tasks/Sensors.h>

#include <cstdio>
#include <string>

namespace antinode
{
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
